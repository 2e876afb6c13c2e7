package badlog.window.graph.scene

import badlog.core.analysis.Span
import badlog.viewer.draw.axis.yParts
import badlog.viewer.session.gesture.PlotDrag
import badlog.viewer.session.gesture.PlotTarget
import badlog.viewer.state.Action
import badlog.viewer.state.GraphChange
import badlog.viewer.state.Place
import badlog.window.graph.plot.PlotPicture
import badlog.window.log.PlotGesture

/**
 * The target of gestures over graph [id], or over the axis and the overview for null.
 *
 * @param picture returns the graph's picture.
 */
internal class ViewTarget(private val scene: GraphScene, private val id: Int? = null, private val picture: () -> PlotPicture? = { null }) :
    PlotTarget {
    private val plot get() = picture()?.plot
    override val place: Place get() = scene.view.place
    override val isCursorLed: Boolean get() = scene.player.state.isPlaying
    override val lineShare: Double get() = plot?.takeIf { it.axes.isNotEmpty() }?.let { 1 - it.laneShare } ?: 0.0
    override var drag: PlotDrag?
        get() = scene.view.gesture?.drag
        set(value) {
            scene.view.gesture = value?.let { PlotGesture(id, it) }
        }

    override fun send(action: Action) = scene.view.send(action)

    override fun showY(part: Span?) {
        if (id == null) return
        val parts = if (part == null) emptyList() else yParts(plot?.axes.orEmpty().map { it.shown }, part)
        scene.board.send(GraphChange.ShowY(id, parts.getOrNull(0), parts.getOrNull(1)))
    }
}
