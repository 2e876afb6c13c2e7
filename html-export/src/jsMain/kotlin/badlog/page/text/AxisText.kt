package badlog.page.text

import kotlin.math.abs

/** What stands at the ticks [values] of an axis, [step] apart: as short as tells them apart. */
internal fun axisTexts(values: Array<Double>, step: Double): Array<String> {
    val largest = values.maxOfOrNull { abs(it) } ?: 0.0
    val decimals = decimalsOf(step)
    val isPlain = largest < LARGEST_PLAIN && step > SMALLEST_PLAIN
    return Array(values.size) { i ->
        when {
            isPlain -> fixedText(values[i], decimals)
            values[i] == 0.0 -> "0"
            else -> values[i].asDynamic().toExponential(2).unsafeCast<String>()
        }
    }
}

private const val LARGEST_PLAIN = 1e7
private const val SMALLEST_PLAIN = 9e-5
