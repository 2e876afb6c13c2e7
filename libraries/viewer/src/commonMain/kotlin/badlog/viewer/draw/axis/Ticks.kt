package badlog.viewer.draw.axis

import badlog.core.analysis.Span
import badlog.viewer.text.exponentialDigits
import badlog.viewer.text.fixedText
import kotlin.math.abs
import kotlin.math.ceil
import kotlin.math.floor
import kotlin.math.log10
import kotlin.math.pow
import kotlin.math.round

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

/**
 * Returns the labels of the ticks [values] of an axis, [step] apart. They are long enough to distinguish the ticks, but have at most
 * [letters] characters. If a number cannot be that short, `…` replaces its beginning, which is the same at all ticks.
 */
internal fun axisTexts(values: DoubleArray, step: Double, letters: Int): List<String> {
    var largest = 0.0
    for (value in values) largest = maxOf(largest, abs(value))
    val plain = if (step > MIN_PLAIN && largest < MAX_PLAIN) plainTexts(values, step) else null
    if (plain != null && longest(plain) <= letters) return plain
    val exponential = exponentialTexts(values, step, largest)
    val shorter = if (plain == null || longest(exponential) < longest(plain)) exponential else plain
    return shorter.map { if (it.length <= letters) it else "…" + it.takeLast(letters - 1) }
}

private fun plainTexts(values: DoubleArray, step: Double): List<String> {
    val decimals = decimalsOf(step)
    return values.map { fixedText(it, decimals) }
}

private fun exponentialTexts(values: DoubleArray, step: Double, largest: Double): List<String> {
    // The digits with which the largest number differs from its neighbors.
    val digits = if (largest > 0) decimalsOf(step / 10.0.pow(floor(log10(largest)))) else 0
    return values.map { if (it == 0.0) "0" else exponentialDigits(it, digits) }
}

private fun longest(texts: List<String>): Int {
    var length = 0
    for (text in texts) length = maxOf(length, text.length)
    return length
}

/** Returns the number of decimals that a multiple of [step] needs. A step has one digit, or two, such as 2.5. */
internal fun decimalsOf(step: Double): Int {
    if (!(step > 0)) return 0
    val ofFirst = ceil(-log10(step) - ROUNDING).toInt().coerceIn(0, MAX_DECIMALS)
    val scaled = step * 10.0.pow(ofFirst)
    val isWhole = abs(scaled - round(scaled)) <= scaled * ROUNDING
    return if (isWhole) ofFirst else minOf(ofFirst + 1, MAX_DECIMALS)
}

private const val MAX_PLAIN = 1e15
private const val MIN_PLAIN = 9e-5
private const val MAX_DECIMALS = 15
private const val ROUNDING = 1e-9
