package badlog.plot.gesture

import badlog.plot.range.Viewport
import kotlin.math.abs
import kotlin.math.exp

/** What the wheel does over graphs: with Ctrl, and as a pinch of a touch pad, it zooms; sideways or with Shift it moves along. */
public class Wheel {
    private var last = Double.NEGATIVE_INFINITY

    /**
     * What is seen of [viewport] after a turn; null where that is not for the graphs, but scrolls them.
     *
     * @param right how far it turned sideways, in CSS pixels or dp.
     * @param down how far it turned towards the person.
     * @param x what is below the pointer.
     * @param width how wide the graphs are, in the same pixels.
     * @param now the time of any clock, in ms; turns that follow one another closely are one step back.
     */
    public fun turned(
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

    public companion object {
        /** So many CSS pixels or dp is a notch of a wheel whose turns are counted. */
        public const val NOTCH: Double = 40.0

        /** How many times as much is seen after a turn [down] with Ctrl. */
        public fun factorOf(down: Double): Double = exp(down.coerceIn(-MAX_TURN, MAX_TURN) * SPEED)

        private const val PAUSE = 500.0
        private const val MAX_TURN = 60.0
        private const val SPEED = 0.008
    }
}
