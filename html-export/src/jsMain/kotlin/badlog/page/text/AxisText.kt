package badlog.page.text

import kotlin.math.abs
import kotlin.math.floor
import kotlin.math.log10
import kotlin.math.pow

/**
 * What stands at the ticks [values] of an axis, [step] apart: no shorter than tells them apart, and no longer than so
 * many [letters]. Of a number that cannot be that short, `…` stands for its beginning, which is the same at all ticks.
 */
internal fun axisTexts(values: Array<Double>, step: Double, letters: Int): Array<String> {
    val largest = values.maxOfOrNull { abs(it) } ?: 0.0
    val plain = if (step > SMALLEST_PLAIN && largest < LARGEST_PLAIN) plainTexts(values, step) else null
    if (plain != null && plain.all { it.length <= letters }) return plain
    val exponential = exponentialTexts(values, step, largest)
    val shorter = if (plain == null || longest(exponential) < longest(plain)) exponential else plain
    return shorter.map { if (it.length <= letters) it else "…" + it.takeLast(letters - 1) }.toTypedArray()
}

private fun plainTexts(values: Array<Double>, step: Double): Array<String> {
    val decimals = decimalsOf(step)
    return values.map { fixedText(it, decimals) }.toTypedArray()
}

private fun exponentialTexts(values: Array<Double>, step: Double, largest: Double): Array<String> {
    // As many digits as the largest one needs to differ from its neighbours.
    val digits = if (largest > 0) decimalsOf(step / 10.0.pow(floor(log10(largest)))) else 0
    return values.map { value ->
        if (value == 0.0) {
            "0"
        } else {
            value.asDynamic().toExponential(digits).unsafeCast<String>().replace("+", "")
        }
    }.toTypedArray()
}

private fun longest(texts: Array<String>) = texts.maxOf { it.length }

private const val LARGEST_PLAIN = 1e15
private const val SMALLEST_PLAIN = 9e-5
