package badlog.viewer.graph

import androidx.compose.ui.Modifier
import androidx.compose.ui.input.pointer.AwaitPointerEventScope
import androidx.compose.ui.input.pointer.PointerEventType
import androidx.compose.ui.input.pointer.PointerInputChange
import androidx.compose.ui.input.pointer.pointerInput
import badlog.viewer.app.Viewer
import kotlin.math.abs

/** Lets the pointer move and resize the visible part over the overview, or choose a new one; a click brings it there. */
internal fun Modifier.overviewPointer(viewer: Viewer): Modifier = pointerInput(viewer) {
    awaitPointerEventScope {
        val pointer = OverviewPointer(this, viewer)
        while (true) {
            val event = awaitPointerEvent()
            pointer.hear(event.type, event.changes.first())
        }
    }
}

private class OverviewPointer(private val scope: AwaitPointerEventScope, private val viewer: Viewer) {
    private val gestures = PlotGestures(viewer)
    private var grip: OverviewGrip? = null
    private var start = 0.0
    private var before = viewer.viewport.visible
    private var hasMoved = false
    private var clickedMillis = Long.MIN_VALUE / 2

    fun hear(type: PointerEventType, change: PointerInputChange) {
        val x = xAt(change)
        when (type) {
            PointerEventType.Press -> press(x)
            PointerEventType.Move -> drag(x)
            PointerEventType.Release -> release(x, change.uptimeMillis)
            PointerEventType.Scroll -> gestures.zoom(change.scrollDelta.y, x, change.uptimeMillis)
            else -> return
        }
        change.consume()
    }

    private fun xAt(change: PointerInputChange): Double {
        val full = viewer.viewport.full
        return (full.from + change.position.x / scope.size.width * full.width).coerceIn(full.from, full.to)
    }

    private fun press(x: Double) {
        start = x
        before = viewer.viewport.visible
        hasMoved = false
        grip = gripAt(x, viewer.viewport, perPixel() * EDGE * scope.density)
    }

    private fun drag(x: Double) {
        val held = grip ?: return
        if (!hasMoved && abs(x - start) < perPixel() * FEWEST * scope.density) return
        if (!hasMoved) {
            viewer.viewport = viewer.viewport.remembered()
            // As for the graphs, Escape gives it up.
            viewer.gesture = PlotGesture(GestureKind.PAN, null, start, Double.NaN, viewer.viewport.copy(visible = before))
        }
        hasMoved = true
        if (viewer.gesture != null) viewer.viewport = viewer.viewport.overviewDragged(held, before, start, x)
    }

    private fun release(x: Double, millis: Long) {
        if (grip == null) return
        if (!hasMoved) click(x, millis)
        grip = null
        viewer.gesture = null
    }

    private fun click(x: Double, millis: Long) {
        if (millis - clickedMillis < DOUBLE_CLICK_MILLIS) {
            viewer.viewport = viewer.viewport.reset()
        } else if (x !in viewer.viewport.visible) {
            viewer.viewport = viewer.viewport.showing(x - before.width / 2, x + before.width / 2)
        }
        clickedMillis = millis
    }

    private fun perPixel() = viewer.viewport.full.width / scope.size.width

    private companion object {
        const val EDGE = 6
        const val FEWEST = 3
        const val DOUBLE_CLICK_MILLIS = 350L
    }
}
