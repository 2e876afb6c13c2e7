package badlog.core.bag

import badlog.core.number.DecimalReader
import badlog.core.text.COMMA
import badlog.core.text.MINUS
import badlog.core.text.PLUS
import badlog.core.text.SPACE
import badlog.core.text.TAB

/** The kinds of content of a cell. They are plain numbers, because a row has hundreds of cells and none may need an object. */
internal object CellKind {
    const val EMPTY = 0
    const val NUMBER = 1
    const val NOT_FINITE = 2
    const val TRUTH_VALUE = 3
    const val TEXT = 4
    const val DECIMAL_COMMA = 5

    /** A whole number that lost its last digits. */
    const val ROUNDED = 6
}

/** Determines the kind of a cell from its bytes. Spaces and tabs around a number are ignored. Not thread-safe. */
internal class CellReader {
    private val decimal = DecimalReader()

    /** The number that [read] or [readWithDecimalComma] found last; NaN if the cell has none. */
    var number: Double = 0.0
        private set

    /** Returns the [CellKind] of the bytes from [from] until [until], which lie inside any quotes. */
    fun read(bytes: ByteArray, from: Int, until: Int): Int {
        var start = from
        var end = until
        while (start < end && isBlank(bytes[start].toInt())) start++
        while (start < end && isBlank(bytes[end - 1].toInt())) end--
        number = Double.NaN
        if (start == end) return CellKind.EMPTY
        if (decimal.read(bytes, start, end)) {
            number = decimal.value
            if (!number.isFinite()) return CellKind.NOT_FINITE
            return if (decimal.isRounded) CellKind.ROUNDED else CellKind.NUMBER
        }
        return readWord(bytes, start, end)
    }

    /** Returns whether the bytes are a number with a decimal comma, such as `1,2345`; it is then in [number]. */
    fun readWithDecimalComma(bytes: ByteArray, from: Int, until: Int): Boolean {
        val found = (from until until).any { bytes[it].toInt() == COMMA } && decimal.read(bytes, from, until, COMMA)
        number = if (found) decimal.value else Double.NaN
        return found
    }

    private fun readWord(bytes: ByteArray, from: Int, until: Int): Int {
        if (until - from > MAX_WORD_LENGTH) return CellKind.TEXT
        if (isWord(bytes, from, until, "null")) return CellKind.EMPTY
        if (isWord(bytes, from, until, "true")) return truth(1.0)
        if (isWord(bytes, from, until, "false")) return truth(0.0)
        if (isWord(bytes, from, until, "nan")) return CellKind.NOT_FINITE
        val sign = bytes[from].toInt()
        val unsigned = if (sign == MINUS || sign == PLUS) from + 1 else from
        if (isWord(bytes, unsigned, until, "infinity") || isWord(bytes, unsigned, until, "inf")) {
            number = if (sign == MINUS) Double.NEGATIVE_INFINITY else Double.POSITIVE_INFINITY
            return CellKind.NOT_FINITE
        }
        return CellKind.TEXT
    }

    private fun truth(value: Double): Int {
        number = value
        return CellKind.TRUTH_VALUE
    }

    private fun isWord(bytes: ByteArray, from: Int, until: Int, word: String): Boolean {
        if (until - from != word.length) return false
        for (i in word.indices) {
            if (bytes[from + i].toInt() or LOWER_CASE != word[i].code) return false
        }
        return true
    }

    private fun isBlank(byte: Int) = byte == SPACE || byte == TAB
}

private const val LOWER_CASE = 32
private const val MAX_WORD_LENGTH = "-infinity".length
