package badlog.page.graph

import badlog.page.view.VisibleRange
import org.w3c.dom.pointerevents.PointerEvent
import kotlin.math.abs

/** Two fingers that zoom: what was between them when they touched the screen stays between them. */
internal class Pinch(private val range: VisibleRange, private val xAt: (Double) -> Double) {
    private val fingers = LinkedHashMap<Int, Double>()
    private var isOn = false

    /** Handles a finger that comes down. Returns true if it is the second one. */
    fun press(event: PointerEvent): Boolean {
        fingers[event.pointerId] = event.clientX.toDouble()
        if (fingers.size == 2) {
            isOn = true
            range.change { remembered() }
        }
        return fingers.size >= 2
    }

    /** Handles a pointer that moves. Returns true if it is one of the fingers of a pinch. */
    fun move(event: PointerEvent): Boolean {
        val before = fingers[event.pointerId] ?: return false
        val x = event.clientX.toDouble()
        val other = fingers.entries.firstOrNull { it.key != event.pointerId }?.value
        fingers[event.pointerId] = x
        if (!isOn || other == null) return isOn
        val oldDistance = abs(before - other)
        val newDistance = abs(x - other)
        if (oldDistance > MIN_DISTANCE && newDistance > MIN_DISTANCE) range.change { scaled(oldDistance / newDistance, xAt(other)) }
        return true
    }

    /** Handles a finger that goes up. Returns true until the pinch is over, so that lifting its fingers is not a tap. */
    fun release(event: PointerEvent): Boolean {
        fingers.remove(event.pointerId)
        val wasOn = isOn
        if (fingers.isEmpty()) isOn = false
        return wasOn
    }

    private companion object {
        /** Fingers closer than this many pixels count as one. */
        const val MIN_DISTANCE = 10.0
    }
}
