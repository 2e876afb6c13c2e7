package badlog.page.graph

import badlog.core.analysis.Span
import badlog.page.dom.add
import badlog.page.dom.isHidden
import badlog.page.dom.showText
import badlog.page.view.Scene
import badlog.page.view.SceneTarget
import badlog.viewer.input.DragKind
import badlog.viewer.session.gesture.PlotDrag
import badlog.viewer.text.lengthText
import org.w3c.dom.HTMLElement

/**
 * The target of gestures over a graph. It shows the range of a drag in [over], which covers the graph's frame.
 *
 * @param onY called with the part of the visible y to show; null for all of it.
 */
internal class GraphTarget(over: HTMLElement, private val scene: Scene, override val lineShare: Double, private val onY: (Span?) -> Unit) :
    SceneTarget(scene) {
    private val selection = over.add("div", "selection").apply { isHidden = true }

    override var drag: PlotDrag? = null
        set(value) {
            field = value
            show(value?.takeIf { it.kind != DragKind.PAN })
        }

    override fun showY(part: Span?) = onY(part)

    private fun show(drag: PlotDrag?) {
        selection.isHidden = drag == null
        if (drag == null) return
        val isY = drag.kind == DragKind.ZOOM_Y
        val now = scene.range.now
        selection.showText(if (isY) "" else "Δ " + lengthText(drag.xSpan.width, scene.xAxis))
        selection.style.left = if (isY) "0" else percent((drag.xSpan.from - now.from) / now.width)
        selection.style.width = if (isY) "100%" else percent(drag.xSpan.width / now.width)
        selection.style.top = if (isY) percent(drag.ySpan.from) else "0"
        selection.style.height = if (isY) percent(drag.ySpan.width) else "100%"
    }

    private fun percent(share: Double) = "${share * 100}%"
}
