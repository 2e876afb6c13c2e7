package badlog.core.text

/**
 * Decodes text that should be UTF-8. Text that is not is read as Windows-1252, in which every byte is a character. Not
 * thread-safe.
 */
public class TextDecoder {
    /** Whether the last text was not UTF-8. */
    public var wasNotUtf8: Boolean = false
        private set

    /** Returns the text of [bytes] from [from] until [until]. */
    public fun decode(bytes: ByteArray, from: Int, until: Int): String {
        wasNotUtf8 = false
        return try {
            bytes.decodeToString(from, until, throwOnInvalidSequence = true)
        } catch (_: CharacterCodingException) {
            wasNotUtf8 = true
            windows1252(bytes, from, until)
        }
    }

    /** Returns whether the bytes are UTF-8; allocates nothing if they are ASCII. */
    public fun isUtf8(bytes: ByteArray, from: Int, until: Int): Boolean {
        for (i in from until until) {
            if (bytes[i] < 0) {
                decode(bytes, i, until)
                return !wasNotUtf8
            }
        }
        return true
    }

    /** Returns the first [most] bytes of a text, for a message; a text that was shortened ends in an ellipsis. */
    public fun excerpt(bytes: ByteArray, from: Int, until: Int, most: Int): String {
        if (until - from <= most) return decode(bytes, from, until)
        var end = from + most
        while (end > from && bytes[end].toInt() and 0xC0 == 0x80) end--
        return decode(bytes, from, end) + "…"
    }

    private fun windows1252(bytes: ByteArray, from: Int, until: Int): String = buildString(until - from) {
        for (i in from until until) {
            val byte = bytes[i].toInt() and 0xff
            append(if (byte in 0x80..0x9f) HIGH_CONTROLS[byte - 0x80] else byte.toChar())
        }
    }
}

// The only place where Windows-1252 differs from Latin-1; its five unassigned bytes stay controls.
private const val HIGH_CONTROLS =
    "\u20AC\u0081\u201A\u0192\u201E\u2026\u2020\u2021\u02C6\u2030\u0160\u2039\u0152\u008D\u017D\u008F" +
        "\u0090\u2018\u2019\u201C\u201D\u2022\u2013\u2014\u02DC\u2122\u0161\u203A\u0153\u009D\u017E\u0178"
