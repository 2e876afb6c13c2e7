package badlog.viewer.graph.text

import badlog.analysis.Units
import java.math.BigDecimal
import java.math.MathContext
import java.math.RoundingMode
import kotlin.math.abs
import kotlin.math.ceil
import kotlin.math.floor
import kotlin.math.log10
import kotlin.math.pow
import kotlin.math.round

/** A sample as a person reads it, and as the exported page writes it: up to seven digits, whole numbers in full, `–` for none. */
internal fun numberText(value: Double): String = when {
    value.isNaN() -> "–"
    !value.isFinite() -> if (value > 0) "∞" else "-∞"
    value == floor(value) && abs(value) < LARGEST_WHOLE -> value.toLong().toString()
    else -> sevenDigits(value)
}

/** [value] with so many [decimals]. */
internal fun fixedText(value: Double, decimals: Int): String = when {
    !value.isFinite() || abs(value) >= LARGEST_WHOLE -> numberText(value)
    else -> BigDecimal(value).setScale(decimals, RoundingMode.HALF_UP).toPlainString()
}

/** How many decimals tell apart places on an axis of which [span] is visible. */
internal fun decimalsFor(span: Double): Int =
    if (span > 0) ceil(DECADES_SEEN - log10(span)).toInt().coerceIn(0, MOST_DECIMALS) else MOST_DECIMALS

/** How many decimals a multiple of [step] needs, which has one or, as 2.5 has, two digits. */
internal fun decimalsOf(step: Double): Int {
    if (!(step > 0)) return 0
    val ofFirst = ceil(-log10(step) - ROUNDING).toInt().coerceIn(0, MOST_TICK_DECIMALS)
    val scaled = step * 10.0.pow(ofFirst)
    val isWhole = abs(scaled - round(scaled)) <= scaled * ROUNDING
    return if (isWhole) ofFirst else minOf(ofFirst + 1, MOST_TICK_DECIMALS)
}

/** A number and its [unit], if it has one. */
internal fun withUnit(number: String, unit: String): String = if (Units.isNone(unit)) number else "$number $unit"

private fun sevenDigits(value: Double): String {
    val rounded = BigDecimal(value).round(MathContext(DIGITS, RoundingMode.HALF_UP))
    val exponent = rounded.precision() - rounded.scale() - 1
    if (exponent in SMALLEST_PLAIN_EXPONENT until DIGITS) return rounded.stripTrailingZeros().toPlainString()
    val mantissa = rounded.movePointLeft(exponent).stripTrailingZeros().toPlainString()
    return "${mantissa}e${if (exponent < 0) "" else "+"}$exponent"
}

private const val LARGEST_WHOLE = 1e15
private const val DIGITS = 7
private const val SMALLEST_PLAIN_EXPONENT = -6
private const val DECADES_SEEN = 4
private const val MOST_DECIMALS = 9
private const val MOST_TICK_DECIMALS = 12
private const val ROUNDING = 1e-9
