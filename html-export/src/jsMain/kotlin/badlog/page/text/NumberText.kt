package badlog.page.text

import kotlin.math.abs
import kotlin.math.ceil
import kotlin.math.floor
import kotlin.math.log10

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

/** How many decimals a multiple of [step] needs. */
internal fun decimalsOf(step: Double): Int =
    if (step > 0) ceil(-log10(step) - ROUNDING).toInt().coerceIn(0, MOST_TICK_DECIMALS) else 0

/** A count with its thousands apart, by a space that does not break. */
internal fun countText(count: Int): String {
    val digits = count.toString()
    if (digits.length <= GROUP + 1) return digits
    return buildString {
        digits.forEachIndexed { index, digit ->
            if (index > 0 && (digits.length - index) % GROUP == 0) append(' ')
            append(digit)
        }
    }
}

/** `1 graph`, `7 graphs`. */
internal fun countText(count: Int, one: String, many: String = one + "s"): String =
    "${countText(count)} ${if (count == 1) one else many}"

/** A number of bytes as a person reads it. */
internal fun bytesText(bytes: Double): String = when {
    bytes < 1000 -> "${bytes.toInt()} bytes"
    bytes < 1e6 -> "${fixedText(bytes / 1e3, 1)} kB"
    bytes < 1e9 -> "${fixedText(bytes / 1e6, 1)} MB"
    else -> "${fixedText(bytes / 1e9, 2)} GB"
}

/** A length of time in seconds as a person says it: `2 min 30 s`. */
internal fun durationText(seconds: Double): String {
    if (seconds < SECONDS_OF_MINUTE) return "${numberText(floor(seconds * 100 + 0.5) / 100)} s"
    val whole = floor(seconds + 0.5).toInt()
    val minutes = whole / SECONDS_OF_MINUTE
    if (minutes < MINUTES_OF_HOUR) return "$minutes min ${whole % SECONDS_OF_MINUTE} s"
    return "${minutes / MINUTES_OF_HOUR} h ${minutes % MINUTES_OF_HOUR} min"
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
private const val GROUP = 3
private const val SECONDS_OF_MINUTE = 60
private const val MINUTES_OF_HOUR = 60
