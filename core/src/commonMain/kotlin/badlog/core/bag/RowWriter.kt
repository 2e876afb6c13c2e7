package badlog.core.bag

import badlog.core.number.ExactFormat
import badlog.core.number.FiveDigitFormat
import badlog.core.number.IntegerFormat
import badlog.core.number.MicrosecondFormat
import badlog.core.text.COMMA
import badlog.core.text.LF
import badlog.core.text.NUL
import badlog.core.text.QUOTE

/**
 * Writes the lines of a bag into its buffer, cell by cell. Numbers are written by [FiveDigitFormat], texts in UTF-8 with quotes according
 * to RFC 4180, and each row ends in one newline. Once the buffer has grown to the longest row, nothing is allocated. Not thread-safe.
 *
 * ```
 * row.number(12.3).text("armed, ready").endRow()
 * file.write(row.bytes, 0, row.size)
 * row.clear()
 * ```
 */
public class RowWriter {
    private var cells = 0
    private var rowStart = 0

    /** The bytes written since the last [clear]: the first [size] of this array. The array is replaced when it grows. */
    public var bytes: ByteArray = ByteArray(1024)
        private set

    /** The number of bytes written since the last [clear]. */
    public var size: Int = 0
        private set

    /** Discards everything written. */
    public fun clear() {
        size = 0
        rowStart = 0
        cells = 0
    }

    /** Writes the two header lines, [headerText] and the titles. The cells of every row must be in the order of the topics. */
    public fun header(header: BagHeader, asOriginal: Boolean = false): RowWriter =
        line(headerText(header, asOriginal)).titles(header.topics.map { it.name })

    /** Writes a line as it is; [text] must have no line end. */
    internal fun line(text: String): RowWriter {
        encode(text, quotesDoubled = false)
        put(LF)
        rowStart = size
        return this
    }

    /** Writes the line of titles. */
    internal fun titles(names: List<String>): RowWriter {
        for (name in names) text(titleOf(name))
        return endRow()
    }

    /** Writes a cell with a number, as `%.5g`. */
    public fun number(value: Double): RowWriter {
        beginCell()
        reserve(FiveDigitFormat.MAX_LENGTH)
        size = FiveDigitFormat.write(value, bytes, size)
        return this
    }

    /**
     * Writes a cell with a number with six decimals, such as `100.020000`, as times need them. A magnitude of 9e18 or
     * more, or a number that is not finite, is written as by [number].
     */
    public fun microseconds(value: Double): RowWriter {
        beginCell()
        reserve(MicrosecondFormat.MAX_LENGTH)
        size = MicrosecondFormat.write(value, bytes, size)
        return this
    }

    /**
     * Writes a cell with a number in enough digits to read the same double again: `0.02`, `12.346`, `-7`, `1e-7`. Infinities and NaN are
     * written as by [number].
     */
    public fun exact(value: Double): RowWriter {
        beginCell()
        reserve(ExactFormat.MAX_LENGTH)
        size = ExactFormat.write(value, bytes, size)
        return this
    }

    /** Writes a cell with all digits of a whole number. */
    public fun integer(value: Long): RowWriter {
        beginCell()
        reserve(IntegerFormat.MAX_LENGTH)
        size = IntegerFormat.write(value, bytes, size)
        return this
    }

    /** Writes a cell with `true` or `false`, which readers show as a state. */
    public fun truth(value: Boolean): RowWriter = text(if (value) "true" else "false")

    /**
     * Writes a cell with a text. A NUL, which in a bag is a sign of damage, becomes U+FFFD. A text that looks like a
     * number is read back as a number.
     */
    public fun text(value: String): RowWriter {
        if (needsQuotes(value)) return quoted(value)
        beginCell()
        encode(value, quotesDoubled = false)
        return this
    }

    /** Writes a cell with a text in quotes, whether it needs them or not. */
    internal fun quoted(value: String): RowWriter {
        beginCell()
        put(QUOTE)
        encode(value, quotesDoubled = true)
        put(QUOTE)
        return this
    }

    /** Writes an empty cell: a gap. */
    public fun empty(): RowWriter {
        beginCell()
        return this
    }

    /** Ends the row. */
    public fun endRow(): RowWriter {
        // A row of one empty cell would be a blank line, which readers skip.
        if (cells == 1 && size == rowStart) {
            put(QUOTE)
            put(QUOTE)
        }
        put(LF)
        cells = 0
        rowStart = size
        return this
    }

    /** Discards the cells written since the last row ended. */
    public fun dropRow() {
        size = rowStart
        cells = 0
    }

    private fun beginCell() {
        if (cells++ > 0) put(COMMA)
    }

    private fun needsQuotes(text: String): Boolean {
        if (text.isEmpty()) return false
        if (text.first().isWhitespace() || text.last().isWhitespace()) return true
        for (char in text) if (char == ',' || char == '"' || char == '\n' || char == '\r') return true
        return false
    }

    private fun encode(text: String, quotesDoubled: Boolean) {
        reserve(text.length * 3)
        var i = 0
        while (i < text.length) {
            val char = text[i++]
            val code = char.code
            when {
                code == NUL -> put3(REPLACEMENT)

                code < 0x80 -> {
                    if (code == QUOTE && quotesDoubled) put(QUOTE)
                    put(code)
                }

                code < 0x800 -> {
                    put(0xC0 or (code shr 6))
                    put(0x80 or (code and 0x3F))
                }

                char.isHighSurrogate() && i < text.length && text[i].isLowSurrogate() -> put4(char, text[i++])

                char.isSurrogate() -> put3(REPLACEMENT)

                else -> put3(code)
            }
        }
    }

    private fun put3(code: Int) {
        put(0xE0 or (code shr 12))
        put(0x80 or (code shr 6 and 0x3F))
        put(0x80 or (code and 0x3F))
    }

    private fun put4(high: Char, low: Char) {
        val code = 0x10000 + ((high.code - 0xD800) shl 10) + (low.code - 0xDC00)
        put(0xF0 or (code shr 18))
        put(0x80 or (code shr 12 and 0x3F))
        put(0x80 or (code shr 6 and 0x3F))
        put(0x80 or (code and 0x3F))
    }

    private fun put(byte: Int) {
        if (size == bytes.size) reserve(1)
        bytes[size++] = byte.toByte()
    }

    private fun reserve(more: Int) {
        if (size + more > bytes.size) bytes = bytes.copyOf(maxOf(bytes.size * 2, size + more))
    }

    internal companion object {
        private const val REPLACEMENT = 0xFFFD

        /** Returns the title of a topic named [name]: the name, except for characters that a line of titles cannot hold. */
        fun titleOf(name: String): String = RowWriter().run {
            encode(name.replace('\n', ' ').replace('\r', ' '), quotesDoubled = false)
            bytes.decodeToString(0, size)
        }
    }
}
