package badlog.window.graph.scene

import androidx.compose.ui.Modifier
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
import badlog.viewer.input.PlotPointer
import badlog.viewer.input.PointerButton
import badlog.viewer.input.Wheel
import badlog.viewer.session.gesture.Gestures

/** Passes the input of a mouse or fingers on to [gestures]. */
internal fun Modifier.receives(gestures: Gestures): Modifier = pointerInput(gestures) {
    awaitPointerEventScope {
        while (true) {
            val event = awaitPointerEvent()
            for (change in event.changes) pass(event, change, gestures)
        }
    }
}

private fun AwaitPointerEventScope.pass(event: PointerEvent, change: PointerInputChange, gestures: Gestures) {
    val at = pointerOf(event, change)
    val wasActive = gestures.isActive
    when (event.type) {
        PointerEventType.Press -> if (change.pressed && !change.previousPressed && !change.isConsumed) gestures.press(at)
        PointerEventType.Move, PointerEventType.Enter -> gestures.move(at)
        PointerEventType.Release -> if (!change.pressed && change.previousPressed) gestures.release(at)
        PointerEventType.Exit -> return gestures.leave()
        PointerEventType.Scroll -> return scroll(change, at, gestures)
        else -> return
    }
    if (wasActive || gestures.isActive) change.consume()
}

private fun scroll(change: PointerInputChange, at: PlotPointer, gestures: Gestures) {
    val (right, down) = change.scrollDelta
    if (!change.isConsumed && gestures.wheel(at, right * Wheel.NOTCH, down * Wheel.NOTCH)) change.consume()
}

private fun AwaitPointerEventScope.pointerOf(event: PointerEvent, change: PointerInputChange): PlotPointer {
    val keys = event.keyboardModifiers
    val (x, y) = change.position / density
    return PlotPointer(
        x.toDouble(),
        y.toDouble(),
        (size.width / density).toDouble(),
        (size.height / density).toDouble(),
        change.uptimeMillis.toDouble(),
        keys.isShiftPressed,
        keys.isAltPressed,
        keys.isCtrlPressed || keys.isMetaPressed,
        when {
            event.buttons.isTertiaryPressed -> PointerButton.MIDDLE
            event.buttons.isSecondaryPressed -> PointerButton.RIGHT
            else -> PointerButton.LEFT
        },
        change.id.value.toInt().takeIf { change.type == PointerType.Touch },
    )
}
