package badlog.core.number

import badlog.core.text.MINUS
import badlog.core.text.ZERO

/** Writes whole numbers as text, with all of their digits. Calls allocate nothing. */
internal object IntegerFormat {
    /** The length in bytes of the longest text that [write] produces: [Long.MIN_VALUE]. */
    const val MAX_LENGTH: Int = 20

    /** Writes [value] into [into] from index [at] on; returns the index after its last digit. */
    fun write(value: Long, into: ByteArray, at: Int): Int {
        // There is one more negative number than positive ones, so the digits are taken from the negative value.
        var rest = if (value > 0) -value else value
        val start = if (value < 0) at + 1 else at
        val end = start + digitsOf(rest)
        if (value < 0) into[at] = MINUS.toByte()
        for (i in end - 1 downTo start) {
            val tens = rest / 10
            into[i] = (ZERO - (rest - tens * 10).toInt()).toByte()
            rest = tens
        }
        return end
    }

    private fun digitsOf(negative: Long): Int {
        var digits = 1
        var rest = negative / 10
        while (rest != 0L) {
            digits++
            rest /= 10
        }
        return digits
    }
}
