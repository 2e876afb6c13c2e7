package badlog.viewer.input

import badlog.viewer.choices.range.Viewport
import kotlin.math.abs
import kotlin.math.exp

/** The wheel over graphs. With Ctrl, or as a pinch on a touch pad, it zooms; sideways or with Shift, it pans. */
class Wheel {
    private var last = Double.NEGATIVE_INFINITY

    /**
     * Returns [viewport] after a turn of the wheel; null if the turn scrolls the page instead.
     *
     * @param right the sideways turn, in CSS pixels or dp.
     * @param down the turn towards the person, in the same pixels.
     * @param x the x under the pointer.
     * @param width the width of the graphs, in the same pixels.
     * @param now the time of any clock, in ms; turns in quick succession are one step of the history.
     */
    fun turned(
        viewport: Viewport,
        right: Double,
        down: Double,
        ctrl: Boolean,
        shift: Boolean,
        x: Double,
        width: Double,
        now: Double,
    ): Viewport? {
        val sideways = if (shift && right == 0.0) down else right
        val pans = !ctrl && viewport.isZoomed && (shift || abs(right) > abs(down))
        if (!ctrl && !pans) return null
        val before = if (now - last > PAUSE) viewport.remembered() else viewport
        last = now
        return if (ctrl) {
            before.scaled(factorOf(down), x)
        } else {
            before.shifted(sideways / width * viewport.visible.width)
        }
    }

    companion object {
        /** The length of one notch in CSS pixels or dp, for a wheel that counts notches. */
        const val NOTCH: Double = 40.0

        /** Returns the factor by which a turn [down] with Ctrl widens the visible range. */
        fun factorOf(down: Double): Double = exp(down.coerceIn(-MAX_TURN, MAX_TURN) * SPEED)

        private const val PAUSE = 500.0
        private const val MAX_TURN = 60.0
        private const val SPEED = 0.008
    }
}
