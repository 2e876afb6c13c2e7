package badlog.page.text

import kotlin.math.abs
import kotlin.math.ceil
import kotlin.math.floor
import kotlin.math.log10
import kotlin.math.pow
import kotlin.math.round

/** A sample as a person reads it: up to seven significant digits, whole numbers in full, `–` for none. */
internal fun numberText(value: Double): String {
    val number: dynamic = value
    return when {
        value.isNaN() -> "–"
        !value.isFinite() -> if (value > 0) "∞" else "-∞"
        value == floor(value) && abs(value) < LARGEST_WHOLE -> number.toString().unsafeCast<String>()
        else -> trimmed(number.toPrecision(DIGITS).unsafeCast<String>())
    }
}

/** [value] with so many [decimals]. */
internal fun fixedText(value: Double, decimals: Int): String {
    val number: dynamic = value
    return if (abs(value) < LARGEST_WHOLE) number.toFixed(decimals).unsafeCast<String>() else numberText(value)
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

private fun trimmed(digits: String): String {
    val exponent = digits.indexOf('e')
    val mantissa = if (exponent < 0) digits else digits.substring(0, exponent)
    val short = if ('.' in mantissa) mantissa.trimEnd('0').trimEnd('.') else mantissa
    return if (exponent < 0) short else short + digits.substring(exponent)
}

private const val LARGEST_WHOLE = 1e15
private const val DIGITS = 7
private const val DECADES_SEEN = 4
private const val MOST_DECIMALS = 9
private const val MOST_TICK_DECIMALS = 12
private const val ROUNDING = 1e-9
