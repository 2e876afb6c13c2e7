package badlog.core.number

import badlog.core.text.MINUS
import badlog.core.text.PLUS
import badlog.core.text.ZERO

/**
 * Writes any [Double] as text with five significant digits, the same as `String.format(Locale.ROOT, "%.5g", value)` on Java 17.
 *
 * | value                                     | texts                                      |
 * |-------------------------------------------|--------------------------------------------|
 * | magnitude after rounding in `[1e-4, 1e5)` | `0.00010000`, `12.346`, `-100.00`, `99999` |
 * | any other finite magnitude above zero     | `1.0000e-05`, `-1.2346e+05`, `1.7977e+308` |
 * | zero                                      | `0.0000`, `-0.0000`                        |
 * | not finite                                | `NaN`, `Infinity`, `-Infinity`             |
 *
 * A text has 3 to [MAX_LENGTH] characters, all of them ASCII, one byte each.
 *
 * Source of the rule: the conversion `g` of `java.util.Formatter` in Java 17. It does not round the binary value but
 * the decimal digits which that release generates for it, half up. So a value just below a decimal tie is rounded up
 * if its digits stop at the tie: the double nearest to 2.00005 is less than that, and its text is `2.0001`. Later
 * Java releases generate other digits and differ for a few values.
 *
 * Calls allocate nothing, except the first one, which builds a table of 8 kB. There is no other state: calls from
 * several threads are safe if their buffers are not shared.
 */
public object FiveDigitFormat {
    /** The length in bytes of the longest text that [write] produces: `-1.7977e+308`. */
    public const val MAX_LENGTH: Int = 12

    private val exactDigits = ExactDigits()

    /**
     * Writes the text of [value] into [into] from index [at] on, and changes nothing else in it.
     *
     * @return the index after the last byte written, `at + 3` to `at + MAX_LENGTH`
     * @throws IndexOutOfBoundsException if [at] is negative or this text does not fit between [at] and the end of
     * [into], which is unchanged then; [MAX_LENGTH] bytes are always enough
     */
    public fun write(value: Double, into: ByteArray, at: Int): Int {
        val magnitude = if (value < 0.0) -value else value
        if (magnitude >= 1.0e-4 && magnitude < 1.0e5) {
            return writeCommon(value < 0.0, magnitude, into, at)
        }
        if (value == 0.0) {
            return writeWord(if (1.0 / value < 0.0) "-0.0000" else "0.0000", into, at)
        }
        if (magnitude <= Double.MAX_VALUE) {
            return writeExact(value < 0.0, magnitude, into, at)
        }
        return writeWord(
            if (value > 0.0) {
                "Infinity"
            } else if (value < 0.0) {
                "-Infinity"
            } else {
                "NaN"
            },
            into,
            at,
        )
    }

    /**
     * Floating point is enough here unless [magnitude] lies next to a decimal tie. The power of ten is exact, so the
     * product, being less than 2^17, is wrong by half a unit in its last place, 2^-37, at most. The digits Java rounds
     * are as close to the value as half a unit of its own last place, less than 2^-36 in the same scale. Nothing
     * farther than 2^-35 from a tie can therefore end up on its other side, and [TIE_DISTANCE] is more than that.
     */
    private fun writeCommon(negative: Boolean, magnitude: Double, into: ByteArray, at: Int): Int {
        val exponent: Int
        val scaled: Double
        if (magnitude >= 1.0) {
            if (magnitude >= 100.0) {
                if (magnitude >= 10000.0) {
                    exponent = 4
                    scaled = magnitude
                } else if (magnitude >= 1000.0) {
                    exponent = 3
                    scaled = magnitude * 1.0e1
                } else {
                    exponent = 2
                    scaled = magnitude * 1.0e2
                }
            } else if (magnitude >= 10.0) {
                exponent = 1
                scaled = magnitude * 1.0e3
            } else {
                exponent = 0
                scaled = magnitude * 1.0e4
            }
        } else if (magnitude >= 0.01) {
            if (magnitude >= 0.1) {
                exponent = -1
                scaled = magnitude * 1.0e5
            } else {
                exponent = -2
                scaled = magnitude * 1.0e6
            }
        } else if (magnitude >= 0.001) {
            exponent = -3
            scaled = magnitude * 1.0e7
        } else {
            exponent = -4
            scaled = magnitude * 1.0e8
        }
        val digits = (scaled + 0.5).toInt()
        val rest = scaled - digits
        if (rest > 0.5 - TIE_DISTANCE || rest < TIE_DISTANCE - 0.5) {
            return writeExact(negative, magnitude, into, at)
        }
        return if (digits == 100_000) {
            writeDigits(negative, 10_000, exponent + 1, into, at)
        } else {
            writeDigits(negative, digits, exponent, into, at)
        }
    }

    private fun writeExact(negative: Boolean, magnitude: Double, into: ByteArray, at: Int): Int {
        val rounded = exactDigits.round(magnitude)
        return writeDigits(negative, ExactDigits.digitsOf(rounded), ExactDigits.exponentOf(rounded), into, at)
    }

    /** Writes `d.dddd` times ten to the [exponent], where [digits] is `ddddd`. */
    private fun writeDigits(negative: Boolean, digits: Int, exponent: Int, into: ByteArray, at: Int): Int {
        val plain = exponent >= -4 && exponent <= 4
        val unsigned = when {
            !plain -> if (exponent > -100 && exponent < 100) 10 else 11
            exponent == 4 -> 5
            exponent >= 0 -> 6
            else -> 6 - exponent
        }
        val end = checkedEnd(into, at, if (negative) unsigned + 1 else unsigned)
        var next = at
        if (negative) into[next++] = MINUS
        if (!plain) {
            writePointed(digits, 1, into, next)
            writeExponent(exponent, into, next + 6)
        } else if (exponent == 4) {
            writePointed(digits, 5, into, next)
        } else if (exponent >= 0) {
            writePointed(digits, exponent + 1, into, next)
        } else {
            into[next] = ZERO
            into[next + 1] = POINT
            next += 2
            while (next < end - 5) into[next++] = ZERO
            writePointed(digits, 5, into, next)
        }
        return end
    }

    /** Writes five [digits] with a point after the first [whole] of them, or without any if all are whole. */
    private fun writePointed(digits: Int, whole: Int, into: ByteArray, at: Int) {
        val upper4 = digits / 10
        val upper3 = upper4 / 10
        val upper2 = upper3 / 10
        val upper1 = upper2 / 10
        into[at] = (DIGIT_0 + upper1).toByte()
        into[if (whole > 1) at + 1 else at + 2] = (DIGIT_0 + upper2 - upper1 * 10).toByte()
        into[if (whole > 2) at + 2 else at + 3] = (DIGIT_0 + upper3 - upper2 * 10).toByte()
        into[if (whole > 3) at + 3 else at + 4] = (DIGIT_0 + upper4 - upper3 * 10).toByte()
        into[if (whole > 4) at + 4 else at + 5] = (DIGIT_0 + digits - upper4 * 10).toByte()
        if (whole < 5) into[at + whole] = POINT
    }

    private fun writeExponent(exponent: Int, into: ByteArray, at: Int) {
        val size = if (exponent < 0) -exponent else exponent
        into[at] = EXPONENT
        into[at + 1] = if (exponent < 0) MINUS else PLUS
        var next = at + 2
        if (size >= 100) into[next++] = (DIGIT_0 + size / 100).toByte()
        into[next] = (DIGIT_0 + size / 10 % 10).toByte()
        into[next + 1] = (DIGIT_0 + size % 10).toByte()
    }

    private fun writeWord(word: String, into: ByteArray, at: Int): Int {
        val end = checkedEnd(into, at, word.length)
        for (i in word.indices) into[at + i] = word[i].code.toByte()
        return end
    }

    /** Checked up front because a store past the end is lost without an error on JavaScript. */
    private fun checkedEnd(into: ByteArray, at: Int, length: Int): Int {
        if (at < 0 || length > into.size - at) {
            throw IndexOutOfBoundsException("$length bytes at index $at do not fit into ${into.size} bytes")
        }
        return at + length
    }

    private const val TIE_DISTANCE = 1.0e-9

    private const val DIGIT_0 = '0'.code
    private const val ZERO = '0'.code.toByte()
    private const val POINT = '.'.code.toByte()
    private const val MINUS = '-'.code.toByte()
    private const val PLUS = '+'.code.toByte()
    private const val EXPONENT = 'e'.code.toByte()
}
