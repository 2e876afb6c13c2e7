package badlog.core.number

import badlog.core.text.DOT
import badlog.core.text.MINUS
import badlog.core.text.NINE
import badlog.core.text.PLUS
import badlog.core.text.ZERO

/**
 * Reads a decimal number from ASCII bytes, rounded correctly, as `String.toDouble` would, in almost every case without
 * creating an object. Not thread-safe.
 *
 * Up to 15 digits with a small exponent are exact in one double operation (Clinger, "How to read floating point numbers
 * accurately", 1990). Longer ones are computed in double-double arithmetic (Dekker, 1971) with a known error bound; only
 * where the bound leaves two candidates does the platform's own conversion decide.
 */
internal class DecimalReader {
    /** The number that [read] found last. */
    var value: Double = 0.0
        private set

    /** Whether the text was a whole number that no double holds exactly. */
    var isRounded: Boolean = false
        private set

    /**
     * Reads `[+-]digits[.digits][e[+-]digits]`, with at least one digit before the exponent.
     *
     * @param point the byte that is the decimal point.
     * @return whether the bytes from [from] until [until] are exactly such a number; it is then in [value].
     */
    fun read(bytes: ByteArray, from: Int, until: Int, point: Int = DOT): Boolean {
        var at = from
        val negative = at < until && bytes[at].toInt() == MINUS
        if (negative || (at < until && bytes[at].toInt() == PLUS)) at++

        // The digits are kept in two numbers that every platform holds exactly, nine digits each.
        var high = 0.0
        var low = 0.0
        var significant = 0
        var digits = 0
        var scale = 0
        var seenPoint = false
        while (at < until) {
            val byte = bytes[at].toInt()
            if (byte in ZERO..NINE) {
                digits++
                if (significant > 0 || byte != ZERO) {
                    significant++
                    if (significant <= 9) high = high * 10 + (byte - ZERO) else low = low * 10 + (byte - ZERO)
                }
                if (seenPoint) scale--
            } else if (byte == point && !seenPoint) {
                seenPoint = true
            } else {
                break
            }
            at++
        }
        isRounded = false
        if (digits == 0) return false
        if (significant > EXACT_DIGITS && !seenPoint && at == until) isRounded = isRounded(bytes, from, until)
        if (at < until) {
            val exponent = readExponent(bytes, at, until)
            if (exponent == NO_EXPONENT) return false
            scale += exponent
        }
        val magnitude = when {
            significant <= 9 && scale in -22..22 -> scaledExactly(high, scale)

            significant <= 15 && scale in -22..22 ->
                scaledExactly(high * EXACT_POWERS_OF_TEN[significant - 9] + low, scale)

            significant <= 18 && scale in -44..44 -> scaledTwofold(high, low, significant, scale)

            else -> Double.NaN
        }
        value = when {
            magnitude.isNaN() -> platformValue(bytes, from, until, point)
            negative -> -magnitude
            else -> magnitude
        }
        return true
    }

    private fun isRounded(bytes: ByteArray, from: Int, until: Int): Boolean {
        val text = bytes.decodeToString(from, until).trimStart('+', '-', '0')
        val digits = text.trimEnd('0')
        val whole = digits.toLongOrNull() ?: return true
        var odd = whole shr whole.countTrailingZeroBits()
        repeat(text.length - digits.length) {
            if (odd > EXACT) return true
            odd *= 5
        }
        return odd > EXACT
    }

    private fun readExponent(bytes: ByteArray, from: Int, until: Int): Int {
        if (bytes[from].toInt() or LOWER_CASE != 'e'.code) return NO_EXPONENT
        var at = from + 1
        val negative = at < until && bytes[at].toInt() == MINUS
        if (negative || (at < until && bytes[at].toInt() == PLUS)) at++
        if (at == until) return NO_EXPONENT
        var exponent = 0
        while (at < until) {
            val digit = bytes[at].toInt() - ZERO
            if (digit !in 0..9) return NO_EXPONENT
            if (exponent < LARGE_EXPONENT) exponent = exponent * 10 + digit
            at++
        }
        return if (negative) -exponent else exponent
    }

    private fun scaledExactly(digits: Double, scale: Int): Double =
        if (scale < 0) digits / EXACT_POWERS_OF_TEN[-scale] else digits * EXACT_POWERS_OF_TEN[scale]

    /** Returns NaN if the error bound leaves open to which double the number rounds. */
    private fun scaledTwofold(high: Double, low: Double, significant: Int, scale: Int): Double {
        val shift = EXACT_POWERS_OF_TEN[maxOf(0, significant - 9)]
        val shifted = high * shift
        var sum = shifted + low
        var rest = productError(high, shift, shifted) + (low - (sum - shifted))
        var left = scale
        while (left != 0) {
            val step = if (left > 0) minOf(left, 22) else maxOf(left, -22)
            if (step > 0) {
                val power = EXACT_POWERS_OF_TEN[step]
                val product = sum * power
                rest = productError(sum, power, product) + rest * power
                sum = product
            } else {
                val power = EXACT_POWERS_OF_TEN[-step]
                val quotient = sum / power
                val back = quotient * power
                rest = ((sum - back) - productError(quotient, power, back) + rest) / power
                sum = quotient
            }
            left -= step
        }
        val result = sum + rest
        val lost = rest - (result - sum)
        val bound = result * TWOFOLD_ERROR
        return if (result + (lost + bound) == result && result + (lost - bound) == result) result else Double.NaN
    }

    /** Returns the exact error of the rounded product [product] of [a] and [b]. */
    private fun productError(a: Double, b: Double, product: Double): Double {
        val aSplit = a * SPLITTER
        val aHigh = aSplit - (aSplit - a)
        val aLow = a - aHigh
        val bSplit = b * SPLITTER
        val bHigh = bSplit - (bSplit - b)
        val bLow = b - bHigh
        return aLow * bLow - (((product - aHigh * bHigh) - aLow * bHigh) - aHigh * bLow)
    }

    private fun platformValue(bytes: ByteArray, from: Int, until: Int, point: Int): Double =
        bytes.decodeToString(from, until).replace(point.toChar(), '.').toDouble()
}

private const val LOWER_CASE = 32

/** Every whole number of up to this many digits is exact in a double. */
private const val EXACT_DIGITS = 15

/** 2^53: an odd number above it is not exact, whatever power of two it is multiplied by. */
private const val EXACT = 1L shl 53
private const val NO_EXPONENT = Int.MIN_VALUE
private const val LARGE_EXPONENT = 100_000

/** 2²⁷ + 1 splits a double into two halves of 26 bits. */
private const val SPLITTER = 134217729.0

/** 2⁻⁹⁶, above the error that at most three multiplications or divisions in double-double leave. */
private const val TWOFOLD_ERROR = 1.262177448353619e-29
