package badlog.viewer.text

import java.math.BigDecimal
import java.math.MathContext
import java.math.RoundingMode
import kotlin.math.abs
import kotlin.math.floor
import kotlin.math.log10
import kotlin.math.pow

/**
 * What stands at the ticks [values] of an axis, [step] apart: no shorter than tells them apart, and no longer than so
 * many [letters]. Of a number that cannot be that short, `…` stands for its beginning, which is the same at all ticks.
 */
internal fun axisTexts(values: DoubleArray, step: Double, letters: Int): List<String> {
    val largest = values.maxOfOrNull { abs(it) } ?: 0.0
    val plain = if (step > SMALLEST_PLAIN && largest < LARGEST_PLAIN) plainTexts(values, step) else null
    if (plain != null && plain.all { it.length <= letters }) return plain
    val exponential = exponentialTexts(values, step, largest)
    val shorter = if (plain == null || exponential.maxOf { it.length } < plain.maxOf { it.length }) exponential else plain
    return shorter.map { if (it.length <= letters) it else "…" + it.takeLast(letters - 1) }
}

private fun plainTexts(values: DoubleArray, step: Double): List<String> {
    val decimals = decimalsOf(step)
    return values.map { fixedText(it, decimals) }
}

private fun exponentialTexts(values: DoubleArray, step: Double, largest: Double): List<String> {
    // As many digits as the largest one needs to differ from its neighbours.
    val digits = if (largest > 0) decimalsOf(step / 10.0.pow(floor(log10(largest)))) else 0
    return values.map { if (it == 0.0) "0" else exponentialText(it, digits) }
}

private fun exponentialText(value: Double, digits: Int): String {
    val rounded = BigDecimal(value).round(MathContext(digits + 1, RoundingMode.HALF_UP))
    val exponent = rounded.precision() - rounded.scale() - 1
    return "${rounded.movePointLeft(exponent).setScale(digits, RoundingMode.HALF_UP).toPlainString()}e$exponent"
}

private const val LARGEST_PLAIN = 1e15
private const val SMALLEST_PLAIN = 9e-5
