package badlog.viewer.draw.axis

import badlog.viewer.text.exponentialDigits
import badlog.viewer.text.fixedText
import kotlin.math.abs
import kotlin.math.ceil
import kotlin.math.floor
import kotlin.math.log10
import kotlin.math.pow
import kotlin.math.round

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
