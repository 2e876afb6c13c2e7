package badlog.window.graph.xy

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import badlog.viewer.choices.board.Plane
import badlog.viewer.draw.path.XyPicture
import badlog.viewer.session.gesture.XyDrag
import badlog.viewer.session.gesture.XyTarget
import badlog.viewer.state.Action
import badlog.viewer.state.Place
import badlog.window.graph.scene.GraphScene

/** The target of gestures over graph [id], which shows [picture]. */
internal class PaneTarget(private val scene: GraphScene, private val id: Int, override val picture: XyPicture) : XyTarget {
    override val place: Place get() = scene.view.place
    override val isCursorLed: Boolean get() = scene.player.state.isPlaying
    override var drag: XyDrag? by mutableStateOf(null)
    override var plane: Plane?
        get() = scene.planes[id]
        set(value) {
            if (value == null) scene.planes.remove(id) else scene.planes[id] = value
        }

    override fun send(action: Action) = scene.view.send(action)
}
