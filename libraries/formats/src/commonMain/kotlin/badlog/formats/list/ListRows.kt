package badlog.formats.list

/**
 * One line of a list.
 *
 * @property line its number, from 1.
 * @property hasComma whether numbers may have a decimal comma.
 */
internal class ListRow(val line: Int, val hasComma: Boolean, private val cells: List<ByteArray>, private val quoted: List<Boolean>) {
    /** Its time in s; null if it has none. */
    val time: Double? get() = numberIn(textOf(0))?.takeIf { it.isFinite() }

    /** The name of its topic; null if the line is too short. */
    val name: String? get() = if (cells.size < CELLS) null else textOf(1)

    /** The bytes of its value. */
    val value: ByteArray get() = cells[2]

    /** Whether its value is in quotes, as only texts are. */
    val isText: Boolean get() = quoted[2]

    /** Its value as a number; null if it is not one. */
    val number: Double? get() = numberIn(textOf(2))

    /** Returns the text of cell [index], which exists. */
    fun textOf(index: Int): String = cells[index].decodeToString()

    /** Returns the number in [text]; null if it is not one. */
    fun numberIn(text: String): Double? {
        val number = if (hasComma) text.replace(',', '.') else text
        return when {
            NUMBER.matches(number) -> number.toDouble()
            number == "NaN" || number == "nan" -> Double.NaN
            number == "Infinity" || number == "inf" -> Double.POSITIVE_INFINITY
            number == "-Infinity" || number == "-inf" -> Double.NEGATIVE_INFINITY
            else -> null
        }
    }

    companion object {
        const val CELLS = 3

        // Two runs of digits that may touch would take a time that grows with the square of their length.
        private val NUMBER = Regex("[+-]?(?:\\d+(?:\\.\\d*)?|\\.\\d+)(?:[eE][+-]?\\d+)?")
    }
}

/**
 * Splits a list into its lines. Quotes follow RFC 4180; everything after the second separator belongs to the value.
 *
 * @param separator the byte between two cells.
 * @param take receives each line that is not blank.
 */
internal class ListRows(private val separator: Int, private val take: (ListRow) -> Unit) {
    private var cell = ByteArray(64)
    private var size = 0
    private val cells = ArrayList<ByteArray>(ListRow.CELLS)
    private val quoted = ArrayList<Boolean>(ListRow.CELLS)
    private var isQuoted = false
    private var isInQuotes = false
    private var endedQuotes = false
    private var isAfterReturn = false

    /** Whether a line has more than [MAX_LINE] bytes, after which nothing is read. */
    var isTooLong = false
        private set
    private var lineSize = 0

    /** The number of the line that is being read, from 1. */
    var line = 1
        private set
    private var lineNow = 1

    fun accept(byte: Byte) {
        if (isTooLong) return
        val value = byte.toInt()
        if (value == LF && isAfterReturn) {
            isAfterReturn = false
            return
        }
        isAfterReturn = value == CR && !isInQuotes
        if (isInQuotes && size > MAX_TEXT) isInQuotes = false
        when {
            value == QUOTE -> acceptQuote()
            isInQuotes -> keep(byte)
            value == separator && cells.size < ListRow.CELLS - 1 -> endCell()
            value == LF || value == CR -> endLine()
            else -> keep(byte)
        }
        if (value == LF || (value == CR && !isInQuotes)) lineNow++
        if (cells.isEmpty() && size == 0 && !isInQuotes) line = lineNow
    }

    private fun acceptQuote() {
        when {
            isInQuotes -> {
                isInQuotes = false
                endedQuotes = true
            }

            endedQuotes -> {
                // Two of them stand for one.
                keep(QUOTE.toByte())
                isInQuotes = true
                endedQuotes = false
            }

            size == 0 && !isQuoted -> {
                isQuoted = true
                isInQuotes = true
            }

            else -> keep(QUOTE.toByte())
        }
    }

    /** Marks the end of the file. */
    fun finish() {
        if (isTooLong) return
        if (size > 0 || isQuoted || cells.isNotEmpty()) endLine()
    }

    private fun keep(byte: Byte) {
        endedQuotes = false
        if (lineSize++ == MAX_LINE) {
            isTooLong = true
            return
        }
        if (size == cell.size) cell = cell.copyOf(size * 2)
        cell[size++] = byte
    }

    private fun endCell() {
        cells += cell.copyOf(size)
        quoted += isQuoted
        size = 0
        isQuoted = false
        isInQuotes = false
        endedQuotes = false
    }

    private fun endLine() {
        if (size == 0 && !isQuoted && cells.isEmpty()) return
        endCell()
        take(ListRow(line, separator != ','.code, cells.toList(), quoted.toList()))
        cells.clear()
        quoted.clear()
        lineSize = 0
    }

    companion object {
        /** The maximum length of a line in bytes, as in a bag. */
        const val MAX_LINE = 1 shl 24
        private const val QUOTE = '"'.code
        private const val LF = '\n'.code
        private const val CR = '\r'.code

        /** A quote that nothing closes must not swallow the file. */
        private const val MAX_TEXT = 1 shl 16
    }
}
