package badlog.window.graph.xy

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Rect
import androidx.compose.ui.input.pointer.AwaitPointerEventScope
import androidx.compose.ui.input.pointer.PointerEvent
import androidx.compose.ui.input.pointer.PointerEventType
import androidx.compose.ui.input.pointer.PointerInputChange
import androidx.compose.ui.input.pointer.PointerType
import androidx.compose.ui.input.pointer.isCtrlPressed
import androidx.compose.ui.input.pointer.isMetaPressed
import androidx.compose.ui.input.pointer.isShiftPressed
import androidx.compose.ui.input.pointer.isTertiaryPressed
import androidx.compose.ui.input.pointer.pointerInput
import badlog.viewer.choices.board.Plane
import badlog.viewer.input.DoubleClick
import badlog.viewer.input.DragKind
import badlog.viewer.input.Wheel
import badlog.window.graph.scene.GraphScene

/** A drag over a path in progress. */
internal class XyDrag {
    /** What it covers, in pixels; null for nothing. */
    var covered: Rect? by mutableStateOf(null)

    /** Cancels it, as for Escape; null while there is none. */
    var giveUp: (() -> Unit)? by mutableStateOf(null)
}

/**
 * Makes the pointer place the cursor where the path passes it, zoom and pan over graph [id], as over other graphs.
 *
 * @param planeOn returns the visible plane for a size in pixels.
 * @param drag receives the current drag, to show it.
 */
internal fun Modifier.xyPointer(
    scene: GraphScene,
    id: Int,
    xys: List<DrawnXy>,
    planeOn: (width: Float, height: Float) -> Plane?,
    drag: XyDrag,
): Modifier = pointerInput(scene, id, xys) {
    awaitPointerEventScope {
        val pointer = XyPointer(this, scene, id, xys, planeOn, drag)
        while (true) pointer.hear(awaitPointerEvent())
    }
}

private class XyPointer(
    private val scope: AwaitPointerEventScope,
    private val scene: GraphScene,
    private val id: Int,
    private val xys: List<DrawnXy>,
    private val planeOn: (width: Float, height: Float) -> Plane?,
    private val drag: XyDrag,
) {
    private val clicks = DoubleClick()
    private var pressedAt: Offset? = null
    private var before: Plane? = null
    private var kept: Plane? = null
    private var isPan = false
    private var isDragging = false

    private val width get() = scope.size.width.toFloat()
    private val height get() = scope.size.height.toFloat()
    private val plane get() = planeOn(width, height)

    fun hear(event: PointerEvent) {
        val fingers = event.changes.filter { it.pressed && it.type == PointerType.Touch }
        if (fingers.size > 1) return pinch(fingers[0], fingers[1])
        val change = event.changes.first()
        when (event.type) {
            PointerEventType.Press -> press(event, change)
            PointerEventType.Move, PointerEventType.Enter -> move(change)
            PointerEventType.Exit -> if (pressedAt == null) scene.gestures.leave()
            PointerEventType.Release -> release(event, change)
            PointerEventType.Scroll -> scroll(event, change)
            else -> Unit
        }
    }

    private fun press(event: PointerEvent, change: PointerInputChange) {
        if (change.isConsumed) return
        pressedAt = change.position
        before = plane
        kept = scene.planes[id]
        isDragging = false
        drag.giveUp = ::giveUp
        isPan = event.keyboardModifiers.isShiftPressed || event.buttons.isTertiaryPressed || change.type == PointerType.Touch
        change.consume()
    }

    private fun move(change: PointerInputChange) {
        val start = pressedAt
        if (start == null) {
            timeAt(change.position)?.let(scene.gestures::hover)
            return
        }
        if (!isDragging && (change.position - start).getDistance() < DragKind.MIN_DISTANCE * scope.density) return
        isDragging = true
        change.consume()
        if (isPan) {
            val plane = before ?: return
            show(
                plane.shifted(
                    share(start.x - change.position.x, width) * plane.x.width,
                    share(change.position.y - start.y, height) * plane.y.width,
                ),
            )
        } else {
            drag.covered = Rect(
                minOf(start.x, change.position.x),
                minOf(start.y, change.position.y),
                maxOf(start.x, change.position.x),
                maxOf(start.y, change.position.y),
            )
        }
    }

    private fun release(event: PointerEvent, change: PointerInputChange) {
        val start = pressedAt ?: return
        stop()
        change.consume()
        val place = change.position
        if (!isDragging) {
            click(event, change)
        } else if (!isPan) {
            before?.part(share(start.x, width), share(start.y, height), share(place.x, width), share(place.y, height))?.let(::show)
        }
    }

    private fun stop() {
        pressedAt = null
        drag.covered = null
        drag.giveUp = null
    }

    private fun giveUp() {
        if (isDragging && isPan) kept.let { if (it == null) scene.planes.remove(id) else scene.planes[id] = it }
        stop()
    }

    /** What was between two fingers stays between them. */
    private fun pinch(one: PointerInputChange, other: PointerInputChange) {
        stop()
        one.consume()
        other.consume()
        val plane = plane ?: return
        val factor = (one.previousPosition - other.previousPosition).getDistance() / (one.position - other.position).getDistance()
        if (!factor.isFinite() || factor <= 0) return
        val from = (one.previousPosition + other.previousPosition) / 2f
        val moved = (one.position + other.position) / 2f - from
        val scaled = plane.scaled(factor.toDouble(), plane.xAt(share(from.x, width)), plane.yAt(share(from.y, height)))
        show(scaled.shifted(-share(moved.x, width) * scaled.x.width, share(moved.y, height) * scaled.y.width))
    }

    private fun click(event: PointerEvent, change: PointerInputChange) {
        if (clicks.isSecond((change.position.x / scope.density).toDouble(), change.uptimeMillis.toDouble())) {
            scene.planes.remove(id)
        } else {
            timeAt(change.position)?.let { scene.gestures.click(it, reach = 0.0, event.keyboardModifiers.isShiftPressed) }
        }
    }

    private fun scroll(event: PointerEvent, change: PointerInputChange) {
        val keys = event.keyboardModifiers
        val plane = plane ?: return
        val down = change.scrollDelta.y.toDouble() * Wheel.NOTCH
        if (!keys.isCtrlPressed && !keys.isMetaPressed) return
        val x = plane.xAt(share(change.position.x, width))
        show(plane.scaled(Wheel.factorOf(down), x, plane.yAt(share(change.position.y, height))))
        change.consume()
    }

    private fun show(plane: Plane) {
        val seen = if (isField(xys)) plane.fitted(width.toDouble(), height.toDouble()) else plane
        if (seen.isDrawable) scene.planes[id] = seen
    }

    /** Returns when the path of the first recording passed [place]; null if it is not near. */
    private fun timeAt(place: Offset): Double? {
        val xy = xys.firstOrNull() ?: return null
        val plane = plane ?: return null
        val time = xy.plot.timeAt(
            x = plane.xAt(share(place.x, width)),
            y = plane.yAt(share(place.y, height)),
            pixelX = plane.x.width / width,
            pixelY = plane.y.width / height,
            reach = (REACH * scope.density).toDouble(),
            visible = xy.own(scene.view.viewport.visible),
            before = scene.view.cursor?.let { it - xy.drawn.offset },
        )
        return if (time.isNaN()) null else time + xy.drawn.offset
    }

    private fun share(pixels: Float, of: Float) = (pixels / of).toDouble()

    private companion object {
        /** The maximum distance from the path at which the pointer still selects it, in dp. */
        const val REACH = 60
    }
}
