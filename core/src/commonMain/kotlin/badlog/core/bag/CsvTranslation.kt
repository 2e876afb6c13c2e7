package badlog.core.bag

import badlog.core.text.COMMA
import badlog.core.text.CR
import badlog.core.text.DOT
import badlog.core.text.LF
import badlog.core.text.MINUS
import badlog.core.text.NINE
import badlog.core.text.NUL
import badlog.core.text.QUOTE
import badlog.core.text.ZERO
import badlog.core.text.microsOfIsoTime
import badlog.core.text.wallTimeText

/**
 * Rewrites a CSV file from [dialect] to the usual form, line by line, as it arrives. Cells that are not numbers in that dialect stay texts.
 */
internal class CsvTranslation(private val dialect: CsvDialect) {
    private var cell = ByteArray(64)
    private var size = 0
    private var index = 0
    private var isTitle = dialect.hasTitles
    private var isInQuotes = false
    private var hasQuotes = false
    private var mayEndQuotes = false
    private val starts = HashMap<Int, Double>()

    /** The first of the times of day; null if there is none. */
    var startText: String? = null
        private set

    /** The rewritten file: the first [outSize] bytes. */
    var out = ByteArray(1 shl 10)
        private set
    var outSize = 0
        private set

    /** Rewrites the bytes from [from] until [until] into [out], and drops its former content. */
    fun accept(bytes: ByteArray, from: Int, until: Int) {
        outSize = 0
        for (at in from until until) accept(bytes[at].toInt())
    }

    /** Rewrites the rest of the file into [out], and drops its former content. */
    fun finish() {
        outSize = 0
        if (size > 0 || hasQuotes) endCell()
    }

    private fun accept(byte: Int) {
        // There may be a billion of them, and whatever was in quotes is lost.
        if (byte == NUL) return putHole()
        if (isInQuotes && size > MAX_TEXT) isInQuotes = false
        if (isInQuotes) {
            keep(byte)
            if (byte == QUOTE) {
                isInQuotes = false
                mayEndQuotes = true
            }
            return
        }
        if (byte == QUOTE && (size == 0 || mayEndQuotes)) {
            isInQuotes = true
            hasQuotes = true
            keep(byte)
            mayEndQuotes = false
            return
        }
        mayEndQuotes = false
        when (byte) {
            dialect.separator -> {
                endCell()
                put(COMMA)
                index++
            }

            LF, CR -> {
                val isBlank = size == 0 && index == 0
                endCell()
                put(byte)
                index = 0
                if (!isBlank) isTitle = false
            }

            else -> keep(byte)
        }
    }

    private fun putHole() {
        endCell()
        put(NUL)
        index = 0
    }

    private fun keep(byte: Int) {
        if (size == MAX_LINE) return
        if (size == cell.size) cell = cell.copyOf(size * 2)
        cell[size++] = byte.toByte()
    }

    private fun endCell() {
        val isWritten = !isTitle && size in 1..MAX_CELL && (putClock() || putNumber())
        if (!isWritten) putText()
        size = 0
        isInQuotes = false
        hasQuotes = false
        mayEndQuotes = false
    }

    private fun putText() {
        if (hasQuotes || dialect.separator == COMMA || !hasSpecial()) {
            for (i in 0 until size) put(cell[i].toInt())
        } else {
            putQuoted()
        }
    }

    private fun hasSpecial() = (0 until size).any { cell[it].toInt() == COMMA || cell[it].toInt() == QUOTE }

    private fun putQuoted() {
        put(QUOTE)
        for (i in 0 until size) {
            if (cell[i].toInt() == QUOTE) put(QUOTE)
            put(cell[i].toInt())
        }
        put(QUOTE)
    }

    private fun putClock(): Boolean {
        val clock = dialect.clocks[index] ?: return false
        val text = text()
        val micros =
            (if (clock == ISO_CLOCK) microsOfIsoTime(text) else text.toDoubleOrNull()?.let { it * clock }) ?: return false
        val first = starts.getOrPut(index) {
            if (startText == null) startText = if (clock == ISO_CLOCK) text else wallTimeText(micros)
            micros
        }
        put(((micros - first) / 1e6).toString())
        return true
    }

    private fun putNumber(): Boolean {
        if (dialect.between == null) return dialect.hasComma && putPlain()
        if (putGrouped(dialect.between.code)) return true
        put(CsvNumber.of(text())?.text(dialect.between, dialect.hasComma) ?: return false)
        return true
    }

    /** Writes a number that has no mark but the decimal one. Returns false for any other cell. */
    private fun putPlain(): Boolean {
        var marks = 0
        var digits = 0
        for (i in 0 until size) {
            val byte = cell[i].toInt()
            if (byte in ZERO..NINE) {
                digits++
            } else if (byte == COMMA || byte == DOT) {
                marks++
            } else if (byte != MINUS || i > 0) {
                return putOdd()
            }
        }
        if (marks != 1 || digits == 0) return putOdd()
        for (i in 0 until size) put(if (cell[i].toInt() == COMMA) DOT else cell[i].toInt())
        return true
    }

    /** Writes a number with [between] between thousands, if it is written as usual; nothing otherwise. */
    private fun putGrouped(between: Int): Boolean {
        val sizeBefore = outSize
        var digits = 0
        var groups = 0
        var hasPoint = false
        var hasDigit = false
        for (i in 0 until size) {
            val byte = cell[i].toInt()
            val isUsual = when {
                byte in ZERO..NINE -> true.also {
                    digits++
                    hasDigit = true
                }

                byte == between && !hasPoint -> (if (groups == 0) digits in 1..GROUP else digits == GROUP).also {
                    groups++
                    digits = 0
                }

                isPoint(byte) && byte != between && !hasPoint -> (groups == 0 || digits == GROUP).also { hasPoint = true }

                else -> byte == MINUS && i == 0
            }
            if (!isUsual) {
                outSize = sizeBefore
                return false
            }
            if (byte != between) put(if (byte == COMMA) DOT else byte)
        }
        // A number with groups does not begin with a zero.
        val first = cell[if (cell[0].toInt() == MINUS && size > 1) 1 else 0].toInt()
        val isWhole = hasDigit && (groups == 0 || (first != ZERO && (hasPoint || digits == GROUP)))
        if (!isWhole) outSize = sizeBefore
        return isWhole
    }

    private fun isPoint(byte: Int) = byte == DOT || (byte == COMMA && dialect.hasComma)

    private fun putOdd(): Boolean {
        put(CsvNumber.of(text())?.text(null, isComma = true) ?: return false)
        return true
    }

    /** The cell without its quotes and the spaces around it, each byte as a character. */
    private fun text(): String {
        val text = CharArray(size) { (cell[it].toInt() and 0xff).toChar() }.concatToString().trim { it <= ' ' && it.code != NUL }
        return if (hasQuotes) text.removeSurrounding("\"").trim() else text
    }

    private fun put(text: String) {
        for (char in text) put(char.code)
    }

    private fun put(byte: Int) {
        if (outSize == out.size) out = out.copyOf(outSize * 2)
        out[outSize++] = byte.toByte()
    }
}

/** The maximum length of a cell with a number or a time. */
private const val MAX_CELL = 64

/** The number of digits between two marks. */
private const val GROUP = 3

/** The maximum length of a cell in bytes; the rest of a longer one is dropped. */
private const val MAX_LINE = 1 shl 24

/** The length of a cell at which an open quote is ignored, so that it does not swallow the file. */
private const val MAX_TEXT = 1 shl 16
