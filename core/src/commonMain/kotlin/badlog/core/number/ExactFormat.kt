package badlog.core.number

import badlog.core.text.DOT
import badlog.core.text.MINUS
import badlog.core.text.ZERO
import kotlin.math.abs
import kotlin.math.floor

/**
 * Writes a number so that a reader gets exactly the same double: `0.02`, `-7`, `1e-7`. If few digits are enough, nothing is allocated;
 * otherwise the platform's digits are used.
 */
internal object ExactFormat {
    /** The length in bytes of the longest text that [write] produces. */
    const val MAX_LENGTH: Int = 25

    // Up to this limit, every whole number is a double.
    private const val WHOLE_LIMIT = 9007199254740992.0
    private const val MAX_DECIMALS = 9

    // Smaller numbers are easier to read with an exponent.
    private const val MIN_PLAIN = 1e-4
    private val PLAIN_EXPONENTS = -4..15

    /** Writes [value] into [into] from index [at] on; returns the index after it. */
    fun write(value: Double, into: ByteArray, at: Int): Int {
        if (!value.isFinite()) return FiveDigitFormat.write(value, into, at)
        var next = at
        if (value < 0 || 1 / value < 0) into[next++] = MINUS.toByte()
        val magnitude = abs(value)
        val end = writeFewDecimals(magnitude, into, next)
        if (end >= 0) return end
        for (char in platformText(magnitude)) into[next++] = char.code.toByte()
        return next
    }

    /** Writes [magnitude] with as many decimals as it needs; returns -1 if it needs many. */
    private fun writeFewDecimals(magnitude: Double, into: ByteArray, at: Int): Int {
        if (magnitude < MIN_PLAIN && magnitude != 0.0) return -1
        for (decimals in 0..MAX_DECIMALS) {
            val power = EXACT_POWERS_OF_TEN[decimals]
            val scaled = magnitude * power
            if (scaled >= WHOLE_LIMIT) return -1
            val digits = floor(scaled + 0.5)
            // The quotient of two exact numbers is the nearest double, and a reader gets the same one.
            if (digits / power == magnitude) return writeDecimals(digits.toLong(), decimals, into, at)
        }
        return -1
    }

    private fun writeDecimals(digits: Long, decimals: Int, into: ByteArray, at: Int): Int {
        if (decimals == 0) return IntegerFormat.write(digits, into, at)
        val power = EXACT_POWERS_OF_TEN[decimals].toLong()
        val whole = digits / power
        val point = IntegerFormat.write(whole, into, at)
        into[point] = DOT.toByte()
        var fraction = (digits - whole * power).toInt()
        for (i in point + decimals downTo point + 1) {
            into[i] = (ZERO + fraction % 10).toByte()
            fraction /= 10
        }
        return point + 1 + decimals
    }

    /** Returns the platform's digits, in a form that is the same on every platform. */
    private fun platformText(magnitude: Double): String {
        val text = magnitude.toString().lowercase()
        val mantissa = text.substringBefore('e')
        val leading = mantissa.replace(".", "")
        val digits = leading.trimStart('0').trimEnd('0')
        val zeros = leading.length - leading.trimStart('0').length
        val exponent = text.substringAfter('e', "0").toInt() + mantissa.substringBefore('.').length - zeros - 1
        val point = exponent + 1
        return when {
            exponent !in PLAIN_EXPONENTS -> scientific(digits, exponent)
            point <= 0 -> "0." + "0".repeat(-point) + digits
            digits.length <= point -> digits.padEnd(point, '0')
            else -> digits.take(point) + "." + digits.drop(point)
        }
    }

    private fun scientific(digits: String, exponent: Int) =
        if (digits.length == 1) "${digits}e$exponent" else "${digits[0]}.${digits.drop(1)}e$exponent"
}
