package badlog.viewer.draw.axis

import badlog.core.analysis.Span
import kotlin.math.ceil
import kotlin.math.floor
import kotlin.math.log10
import kotlin.math.pow

/**
 * The labeled places of an axis: multiples of [step], which is 1, 2 or 5 times a power of ten.
 *
 * @property values the places, ascending.
 */
class Ticks private constructor(val values: DoubleArray, val step: Double, private val letters: Int) {
    /**
     * The label of each of [values], short enough for its space, and different from all others. If a number cannot be that short, `…`
     * replaces its beginning, which is the same at all ticks.
     */
    val texts: List<String> by lazy(LazyThreadSafetyMode.NONE) { axisTexts(values, step, letters) }

    companion object {
        /** Returns the ticks of an x axis that shows [visible] on [width], in CSS pixels or dp. */
        fun ofX(visible: Span, width: Double): Ticks = of(visible, (width / X_SPACE).toInt().coerceAtLeast(1), X_LETTERS)

        /** Returns the ticks of a y axis that shows [shown] on [height], in CSS pixels or dp. */
        fun ofY(shown: Span, height: Double): Ticks = of(shown, (height / Y_SPACE).toInt().coerceIn(1, MAX_Y_TICKS), Y_LETTERS)

        /** Returns at most [most] + 1 ticks in [shown]; none if that is empty or infinite. */
        internal fun of(shown: Span, most: Int, letters: Int): Ticks {
            val width = shown.width
            if (!(width > 0) || !width.isFinite() || most < 1) return Ticks(DoubleArray(0), 1.0, letters)
            val step = stepFor(width / most)
            val first = ceil(shown.from / step)
            // No number of ticks is correct if neighboring doubles are further apart than the step.
            val count = (floor(shown.to / step) - first + 1).coerceIn(0.0, most + 1.0).toInt()
            return Ticks(DoubleArray(count) { (first + it) * step + 0.0 }, step, letters)
        }

        private fun stepFor(least: Double): Double {
            val power = 10.0.pow(floor(log10(least)))
            val enough = least * (1 - ROUNDING)
            val factor = when {
                power >= enough -> 1
                2 * power >= enough -> 2
                5 * power >= enough -> 5
                else -> 10
            }
            return factor * power
        }

        private const val ROUNDING = 1e-9

        // The width of the widest label, plus some space.
        private const val X_SPACE = 90
        private const val X_LETTERS = 12
        private const val Y_SPACE = 18
        private const val Y_LETTERS = 8
        private const val MAX_Y_TICKS = 12
    }
}
