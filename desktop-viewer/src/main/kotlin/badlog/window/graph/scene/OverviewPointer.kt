package badlog.window.graph.scene

import androidx.compose.ui.Modifier
import androidx.compose.ui.input.pointer.AwaitPointerEventScope
import androidx.compose.ui.input.pointer.PointerEvent
import androidx.compose.ui.input.pointer.PointerEventType
import androidx.compose.ui.input.pointer.PointerInputChange
import androidx.compose.ui.input.pointer.isCtrlPressed
import androidx.compose.ui.input.pointer.isMetaPressed
import androidx.compose.ui.input.pointer.isShiftPressed
import androidx.compose.ui.input.pointer.pointerInput
import badlog.viewer.input.DoubleClick
import badlog.viewer.input.DragKind
import badlog.viewer.input.OverviewDrag
import badlog.window.log.AxisView
import badlog.window.log.PlotGesture

/** Makes the pointer move and resize the visible part on the overview, or select a new one; a click moves it there. */
internal fun Modifier.overviewPointer(scene: GraphScene): Modifier = pointerInput(scene) {
    awaitPointerEventScope {
        val pointer = OverviewPointer(this, scene.view, scene.gestures)
        while (true) {
            val event = awaitPointerEvent()
            pointer.hear(event, event.changes.first())
        }
    }
}

private class OverviewPointer(private val scope: AwaitPointerEventScope, private val view: AxisView, private val gestures: PlotGestures) {
    private val clicks = DoubleClick()
    private var drag: OverviewDrag? = null

    fun hear(event: PointerEvent, change: PointerInputChange) {
        val x = xAt(change)
        when (event.type) {
            PointerEventType.Press -> drag = OverviewDrag(view.viewport, x, view.viewport.full.width / width)
            PointerEventType.Move -> drag?.let { drag(it, x) }
            PointerEventType.Release -> drag?.let { release(it, x, change) }
            PointerEventType.Scroll -> if (!scroll(event, change, x)) return
            else -> return
        }
        change.consume()
    }

    private val width get() = scope.size.width / scope.density

    private fun xAt(change: PointerInputChange): Double {
        val full = view.viewport.full
        return (full.from + change.position.x / scope.size.width * full.width).coerceIn(full.from, full.to)
    }

    private fun drag(drag: OverviewDrag, x: Double) {
        val wasMoved = drag.hasMoved
        val moved = drag.movedTo(x)
        if (!drag.hasMoved) return
        // As for the graphs, Escape cancels it.
        if (!wasMoved) view.drag(PlotGesture(DragKind.PAN, null, x, Double.NaN, drag.before))
        if (view.gesture != null) view.change { moved }
    }

    private fun release(drag: OverviewDrag, x: Double, change: PointerInputChange) {
        this.drag = null
        view.drag(null)
        if (drag.hasMoved) return
        val isSecond = clicks.isSecond((change.position.x / scope.density).toDouble(), change.uptimeMillis.toDouble())
        view.change { if (isSecond) reset() else drag.clicked(x) }
    }

    private fun scroll(event: PointerEvent, change: PointerInputChange, x: Double): Boolean {
        val keys = event.keyboardModifiers
        val isCtrl = keys.isCtrlPressed || keys.isMetaPressed
        return gestures.wheel(change.scrollDelta, isCtrl, keys.isShiftPressed, x, width, change.uptimeMillis)
    }
}
