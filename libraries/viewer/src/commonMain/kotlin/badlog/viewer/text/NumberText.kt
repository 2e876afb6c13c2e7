package badlog.viewer.text

import badlog.core.analysis.Units
import kotlin.math.abs
import kotlin.math.ceil
import kotlin.math.floor
import kotlin.math.log10

/**
 * Returns [value] exactly, with the fewest digits that distinguish it from every other double; `–` for NaN. The text is the same on every
 * platform. Whole numbers below 1e15 are written in full; others below 1e-4 or from 1e15 on have an exponent.
 */
fun exactText(value: Double): String = when {
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

/**
 * Returns [value] for reading. Whole numbers are in full, others have six significant digits, but no zeros in place of digits before the
 * point. Files, copies and tooltips use [exactText].
 */
fun numberText(value: Double): String = when {
    abs(value) < MAX_PLAIN && (value == floor(value) || abs(value) >= MILLION) -> fixedDigits(value, 0)
    value.isFinite() -> shortened(exponentialDigits(value, ROUNDED))
    else -> exactText(value)
}

/** Returns [value] with [decimals] decimals, or its [exactText] if it is not finite, or 1e15 or more. */
fun fixedText(value: Double, decimals: Int): String =
    if (value.isFinite() && abs(value) < MAX_PLAIN) fixedDigits(value, decimals) else exactText(value)

/** Returns the number of decimals that distinguish places on an axis with [span] visible. */
fun decimalsFor(span: Double): Int = if (span > 0) ceil(DECADES_SEEN - log10(span)).toInt().coerceIn(0, MAX_DECIMALS) else MAX_DECIMALS

/** Returns the displayed text of a unit; empty if there is none. */
fun unitText(unit: String): String = if (Units.isNone(unit)) "" else unit

/** Returns [number] with its [unit], if it has one. */
fun withUnit(number: String, unit: String): String = if (Units.isNone(unit) || number == NO_NUMBER) number else "$number $unit"

/** The text for a missing number. */
const val NO_NUMBER: String = "–"

/** Returns [digits], which are in powers of ten, without unnecessary zeros, and without an exponent if that is not longer. */
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
private const val MILLION = 1e6
private const val MIN_EXPONENT = -4
private const val MAX_EXPONENT = 15

// The largest number of decimals, after one digit before the point, with which all decimal numbers differ as doubles. Two more
// distinguish all doubles.
private const val MIN_EXACT_DIGITS = 14
private const val MAX_EXACT_DIGITS = 16
private const val ROUNDED = 5
private const val DECADES_SEEN = 4
private const val MAX_DECIMALS = 9
