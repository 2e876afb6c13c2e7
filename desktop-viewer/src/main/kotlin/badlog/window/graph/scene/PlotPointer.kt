package badlog.window.graph.scene

import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.input.pointer.AwaitPointerEventScope
import androidx.compose.ui.input.pointer.PointerEvent
import androidx.compose.ui.input.pointer.PointerEventType
import androidx.compose.ui.input.pointer.PointerInputChange
import androidx.compose.ui.input.pointer.PointerType
import androidx.compose.ui.input.pointer.isAltPressed
import androidx.compose.ui.input.pointer.isCtrlPressed
import androidx.compose.ui.input.pointer.isMetaPressed
import androidx.compose.ui.input.pointer.isSecondaryPressed
import androidx.compose.ui.input.pointer.isShiftPressed
import androidx.compose.ui.input.pointer.isTertiaryPressed
import androidx.compose.ui.input.pointer.pointerInput
import badlog.viewer.input.DoubleClick
import badlog.viewer.input.DragKind
import badlog.viewer.shown.cursor.Cursors

/**
 * Makes the pointer zoom, pan, select, and place the cursor over graph [id], or over the axis for null, where a plain drag
 * pans.
 *
 * @param yAt returns the value at a number of pixels from the top, given the height.
 */
internal fun Modifier.plotPointer(scene: GraphScene, id: Int?, yAt: (y: Float, height: Float) -> Double): Modifier =
    pointerInput(scene, id) {
        awaitPointerEventScope {
            val pointer = PlotPointer(this, scene, id, yAt)
            while (true) pointer.hear(awaitPointerEvent())
        }
    }

/** Translates pointer events over one plot to [PlotGestures]. */
private class PlotPointer(
    private val scope: AwaitPointerEventScope,
    private val scene: GraphScene,
    private val id: Int?,
    private val yAt: (y: Float, height: Float) -> Double,
) {
    private val gestures = scene.gestures
    private var pressedAt: Offset? = null
    private var kind = DragKind.ZOOM
    private var isDragging = false
    private val clicks = DoubleClick()

    fun hear(event: PointerEvent) {
        val change = event.changes.first()
        when (event.type) {
            PointerEventType.Press -> press(event, change)
            PointerEventType.Move, PointerEventType.Enter -> move(change)
            PointerEventType.Exit -> if (pressedAt == null) gestures.leave()
            PointerEventType.Release -> release(event, change)
            PointerEventType.Scroll -> scroll(event, change)
            else -> Unit
        }
    }

    private fun press(event: PointerEvent, change: PointerInputChange) {
        if (pressedAt != null || change.isConsumed) return
        kind = kindOf(event, change)
        pressedAt = change.position
        isDragging = false
        change.consume()
    }

    private fun kindOf(event: PointerEvent, change: PointerInputChange): DragKind {
        val keys = event.keyboardModifiers
        return when {
            event.buttons.isTertiaryPressed || change.type == PointerType.Touch -> DragKind.PAN
            event.buttons.isSecondaryPressed || keys.isCtrlPressed || keys.isMetaPressed -> DragKind.SELECT
            id == null -> DragKind.PAN
            else -> DragKind.of(keys.isShiftPressed, keys.isAltPressed)
        }
    }

    private fun move(change: PointerInputChange) {
        val start = pressedAt
        val at = change.position
        if (start == null) {
            gestures.hover(xAt(at))
            return
        }
        if (!isDragging && (at - start).getDistance() >= DragKind.MIN_DISTANCE * scope.density) {
            isDragging = true
            gestures.begin(kind, id, xAt(start), yAt(start))
        }
        if (isDragging) gestures.drag(xAt(at), yAt(at))
        change.consume()
    }

    private fun release(event: PointerEvent, change: PointerInputChange) {
        if (pressedAt == null) return
        pressedAt = null
        if (isDragging) {
            gestures.end()
        } else if (kind != DragKind.SELECT) {
            click(change, event.keyboardModifiers.isShiftPressed)
        }
        isDragging = false
        change.consume()
    }

    private fun click(change: PointerInputChange, shift: Boolean) {
        val at = change.position
        if (!shift && clicks.isSecond((at.x / scope.density).toDouble(), change.uptimeMillis.toDouble())) {
            gestures.doubleClick(id)
        } else {
            val reach = Cursors.REACH * scope.density / scope.size.width * scene.view.viewport.visible.width
            gestures.click(xAt(at), reach, shift)
        }
    }

    private fun scroll(event: PointerEvent, change: PointerInputChange) {
        if (change.isConsumed) return
        val keys = event.keyboardModifiers
        val width = scope.size.width / scope.density
        val isCtrl = keys.isCtrlPressed || keys.isMetaPressed
        if (gestures.wheel(change.scrollDelta, isCtrl, keys.isShiftPressed, xAt(change.position), width, change.uptimeMillis)) {
            change.consume()
        }
    }

    private fun xAt(at: Offset): Double {
        val visible = scene.view.viewport.visible
        return visible.from + at.x / scope.size.width * visible.width
    }

    private fun yAt(at: Offset): Double = yAt(at.y, scope.size.height.toFloat())
}
