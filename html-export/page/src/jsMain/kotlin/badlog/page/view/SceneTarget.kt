package badlog.page.view

import badlog.viewer.session.gesture.PlotDrag
import badlog.viewer.session.gesture.PlotTarget
import badlog.viewer.state.Action
import badlog.viewer.state.Place

/** The target of gestures on the page: they change the reader’s place. */
internal open class SceneTarget(private val scene: Scene) : PlotTarget {
    override val place: Place get() = scene.store.place
    override var drag: PlotDrag? = null

    override fun send(action: Action) = scene.store.send(action)
}
