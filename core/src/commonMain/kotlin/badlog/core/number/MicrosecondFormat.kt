package badlog.core.number

import badlog.core.text.DOT
import badlog.core.text.MINUS
import badlog.core.text.ZERO

/**
 * Writes a number with six decimals, for times in seconds. `%.5g` only resolves 10 ms from 100 s on. A magnitude of 9e18 or more, or a
 * number that is not finite, is written by [FiveDigitFormat]. Calls allocate nothing.
 */
internal object MicrosecondFormat {
    /** The length in bytes of the longest text that [write] produces. */
    const val MAX_LENGTH: Int = 27

    private const val FRACTION_DIGITS = 6

    /** Writes [value], rounded to the nearest millionth, into [into] from index [at] on; returns the index after it. */
    fun write(value: Double, into: ByteArray, at: Int): Int {
        val magnitude = if (value < 0.0) -value else value
        if (!(magnitude < 9.0e18)) return FiveDigitFormat.write(value, into, at)
        var whole = magnitude.toLong()
        var millionths = ((magnitude - whole) * 1_000_000 + 0.5).toInt()
        if (millionths == 1_000_000) {
            whole++
            millionths = 0
        }
        var next = at
        if (value < 0.0 && (whole > 0 || millionths > 0)) into[next++] = MINUS.toByte()
        next = IntegerFormat.write(whole, into, next)
        into[next] = DOT.toByte()
        for (i in next + FRACTION_DIGITS downTo next + 1) {
            into[i] = (ZERO + millionths % 10).toByte()
            millionths /= 10
        }
        return next + 1 + FRACTION_DIGITS
    }
}
