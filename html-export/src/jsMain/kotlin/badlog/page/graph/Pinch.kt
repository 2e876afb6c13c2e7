package badlog.page.graph

import badlog.page.view.VisibleRange
import org.w3c.dom.pointerevents.PointerEvent
import kotlin.math.abs

/** Two fingers that zoom: what was between them when they met stays between them. */
internal class Pinch(private val range: VisibleRange, private val xAt: (Double) -> Double) {
    private val fingers = LinkedHashMap<Int, Double>()
    private var isOn = false

    /** A finger comes down; true when it is the second one. */
    fun press(event: PointerEvent): Boolean {
        fingers[event.pointerId] = event.clientX.toDouble()
        if (fingers.size == 2) {
            isOn = true
            range.change { remembered() }
        }
        return fingers.size >= 2
    }

    /** A pointer moves; true when it is one of the fingers of a pinch. */
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

    /** A finger goes up; true while a pinch is not over, so that lifting its fingers is not a tap. */
    fun release(event: PointerEvent): Boolean {
        fingers.remove(event.pointerId)
        val wasOn = isOn
        if (fingers.isEmpty()) isOn = false
        return wasOn
    }

    private companion object {
        /** Fingers nearer than so many pixels are one. */
        const val MIN_DISTANCE = 10.0
    }
}
