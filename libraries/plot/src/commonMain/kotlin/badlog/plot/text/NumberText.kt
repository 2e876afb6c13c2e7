package badlog.plot.text

import badlog.analysis.Units
import kotlin.math.abs
import kotlin.math.ceil
import kotlin.math.floor
import kotlin.math.log10

/**
 * A sample exactly as it is, in as few digits as distinguish it from every other number, the same on every platform; `–` for none.
 * Whole numbers below 1e15 are written in full, others of less than 1e-4 or from 1e15 on with an exponent.
 */
public fun exactText(value: Double): String = when {
    value.isNaN() -> NO_NUMBER

    value.isInfinite() -> if (value > 0) "∞" else "-∞"

    value == 0.0 -> "0"

    value == floor(value) && abs(value) < MAX_PLAIN -> fixedDigits(value, 0)

    else -> {
        var digits = exponentialDigits(value, MIN_EXACT_DIGITS)
        for (decimals in MIN_EXACT_DIGITS + 1..MAX_EXACT_DIGITS) {
            if (digits.toDouble() == value) break
            digits = exponentialDigits(value, decimals)
        }
        shortened(digits)
    }
}

/** A number that was calculated, and so is not exact to the last of its digits: six of them. */
public fun roundedText(value: Double): String =
    if (value.isFinite() && value != 0.0) shortened(exponentialDigits(value, ROUNDED)) else exactText(value)

/** [value] with so many [decimals]; as [exactText] has it where it is not finite or 1e15 and more. */
public fun fixedText(value: Double, decimals: Int): String =
    if (value.isFinite() && abs(value) < MAX_PLAIN) fixedDigits(value, decimals) else exactText(value)

/** How many decimals distinguish places on an axis of which a screen shows [span]. */
public fun decimalsFor(span: Double): Int =
    if (span > 0) ceil(DECADES_SEEN - log10(span)).toInt().coerceIn(0, MAX_DECIMALS) else MAX_DECIMALS

/** A unit as it is shown: nothing for none. */
public fun unitText(unit: String): String = if (Units.isNone(unit)) "" else unit

/** [number] and its [unit], where it has one. */
public fun withUnit(number: String, unit: String): String = if (Units.isNone(unit) || number == NO_NUMBER) number else "$number $unit"

/** What stands for a number where there is none. */
public const val NO_NUMBER: String = "–"

/** [digits], in powers of ten, without needless zeros, and without an exponent where that is no longer. */
private fun shortened(digits: String): String {
    val e = digits.indexOf('e')
    val exponent = digits.substring(e + 1).toInt()
    val sign = if (digits[0] == '-') "-" else ""
    val mantissa = digits.substring(sign.length, e).trimEnd('0').trimEnd('.')
    if (exponent !in MIN_EXPONENT until MAX_EXPONENT) return "$sign${mantissa}e$exponent"
    val all = mantissa.replace(".", "")
    return sign + when {
        exponent < 0 -> "0." + "0".repeat(-exponent - 1) + all
        exponent < all.length - 1 -> all.substring(0, exponent + 1) + "." + all.substring(exponent + 1)
        else -> all + "0".repeat(exponent + 1 - all.length)
    }
}

private const val MAX_PLAIN = 1e15
private const val MIN_EXPONENT = -4
private const val MAX_EXPONENT = 15

// Every decimal number of so many digits, one more than these decimals, differs from its neighbors; with two more, all numbers do.
private const val MIN_EXACT_DIGITS = 14
private const val MAX_EXACT_DIGITS = 16
private const val ROUNDED = 5
private const val DECADES_SEEN = 4
private const val MAX_DECIMALS = 9
