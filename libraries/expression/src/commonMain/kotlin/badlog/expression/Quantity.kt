package badlog.expression

import kotlin.math.abs
import kotlin.math.floor
import kotlin.math.log10
import kotlin.math.pow
import kotlin.math.round

/**
 * A number that belongs to an answer.
 *
 * @property name the part of the expression that has this value, as written, or reduced to one number, such as `min(…)`.
 * @property value the number; NaN when there is none.
 * @property unit its unit if known, otherwise empty.
 * @property time its time, in the unit of the recording's x; NaN if it has none.
 */
data class Quantity(val name: String, val value: Double, val unit: String, val time: Double) {
    /** The number with its unit, in at most six digits: `6.7 V`. */
    val text: String get() = readable(value) + if (unit.isEmpty() || !value.isFinite()) "" else " $unit"

    /** Returns text such as `min(Battery Voltage) = 6.7 V`. */
    override fun toString(): String = "$name = $text"
}

/** Returns [value] with at most six significant digits, the same on every platform: `6.7`, `0.000123457`, `1.5e+20`. */
internal fun readable(value: Double): String {
    if (!value.isFinite()) {
        return if (value.isNaN()) {
            "no value"
        } else if (value > 0) {
            "infinite"
        } else {
            "-infinite"
        }
    }
    val size = abs(value)
    if (size == 0.0) return "0"
    val sign = if (value < 0) "-" else ""
    val exponent = floor(log10(size)).toInt()
    if (exponent in PLAIN) return sign + plain(size, maxOf(0, DIGITS - 1 - exponent))
    // In two steps, since the power of ten for the smallest numbers would be too large.
    val mantissa = if (exponent < 0) size * 1e16 * 10.0.pow(-exponent - 16) else size / 10.0.pow(exponent)
    val written = plain(mantissa, DIGITS - 1)
    val isTen = written == "10"
    val shown = exponent + if (isTen) 1 else 0
    return "$sign${if (isTen) "1" else written}e${if (shown < 0) "-" else "+"}${abs(shown)}"
}

private fun plain(size: Double, decimals: Int): String {
    val digits = round(size * 10.0.pow(decimals)).toLong().toString().padStart(decimals + 1, '0')
    val whole = digits.dropLast(decimals)
    val fraction = digits.takeLast(decimals).trimEnd('0')
    return if (fraction.isEmpty()) whole else "$whole.$fraction"
}

private const val DIGITS = 6
private val PLAIN = -5..9
