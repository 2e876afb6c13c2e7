package badlog.core.bag

import badlog.core.number.EXACT_POWERS_OF_TEN
import badlog.core.text.COMMA
import badlog.core.text.CR
import badlog.core.text.DOT
import badlog.core.text.LF
import badlog.core.text.MINUS
import badlog.core.text.NINE
import badlog.core.text.NUL
import badlog.core.text.QUOTE
import badlog.core.text.ZERO

/**
 * Reads plain rows fast: those without quotes, NULs and missing cells, as nearly all rows are. All others are left to [RowRepair], which is
 * thorough rather than fast.
 */
internal class RowScanner(private val cells: RowCells, private val reader: CellReader) {
    /**
     * Reads the row that begins at [from] into the cells. A line end or a NUL must follow, so that the end is not checked at every byte.
     *
     * @return where the next row begins; [INCOMPLETE] if it ends in what may be half of a CRLF; [IRREGULAR] if it is not plain.
     */
    fun scan(bytes: ByteArray, from: Int, until: Int): Int {
        val last = cells.columns - 1
        val kinds = cells.kinds
        val numbers = cells.numbers
        var cell = 0
        var at = from
        while (true) {
            val start = at
            var byte = bytes[at].toInt()
            val negative = byte == MINUS
            if (negative) {
                byte = bytes[++at].toInt()
            }
            val first = at
            var mantissa = 0
            while (byte in ZERO..NINE) {
                mantissa = mantissa * 10 + (byte - ZERO)
                byte = bytes[++at].toInt()
            }
            var digits = at - first
            var scale = 0
            if (byte == DOT) {
                byte = bytes[++at].toInt()
                val fraction = at
                while (byte in ZERO..NINE) {
                    mantissa = mantissa * 10 + (byte - ZERO)
                    byte = bytes[++at].toInt()
                }
                scale = at - fraction
                digits += scale
            }
            if (digits in 1..MAX_MANTISSA_DIGITS && (byte == COMMA || byte == LF || byte == CR)) {
                val magnitude = if (scale == 0) mantissa.toDouble() else mantissa / EXACT_POWERS_OF_TEN[scale]
                kinds[cell] = CellKind.NUMBER
                numbers[cell] = if (negative) -magnitude else magnitude
            } else {
                while (byte != COMMA && byte != LF && byte != CR) {
                    if (byte == QUOTE || byte == NUL) return IRREGULAR
                    byte = bytes[++at].toInt()
                }
                if (at == start && cell == 0 && byte != COMMA) return IRREGULAR
                kinds[cell] = if (at == start) CellKind.EMPTY else reader.read(bytes, start, at)
                numbers[cell] = reader.number
                cells.starts[cell] = start
                cells.ends[cell] = at
            }
            at++
            if (byte == COMMA) {
                if (++cell > last) return IRREGULAR
            } else {
                if (cell != last) return IRREGULAR
                return afterLineEnd(bytes, at - 1, until, false)
            }
        }
    }

    companion object {
        const val INCOMPLETE = -1
        const val IRREGULAR = -2

        /** Nine decimal digits fit an Int. */
        private const val MAX_MANTISSA_DIGITS = 9
    }
}

/**
 * The cells of one row, on their way from bytes to columns. A row is added to the columns only after all of it was read,
 * so a row that turns out to be cut or irregular leaves no trace.
 *
 * @property columns the number of cells in a row.
 */
internal class RowCells(val columns: Int) {
    /** The [CellKind] of each cell. */
    val kinds = IntArray(columns)

    /** The number of each cell that has one. */
    val numbers = DoubleArray(columns)

    /** Where the bytes of each text cell begin and end. */
    val starts = IntArray(columns)
    val ends = IntArray(columns)

    /** Adds the row to the columns as row number [row]; [line] is the line it is on. */
    fun commit(builders: Array<ColumnBuilder>, row: Int, bytes: ByteArray, line: Int) {
        for (i in builders.indices) {
            val column = builders[i]
            when (kinds[i]) {
                CellKind.NUMBER -> column.addNumber(row, numbers[i])
                CellKind.EMPTY -> column.addEmpty(row)
                CellKind.NOT_FINITE -> column.addNotFinite(row, numbers[i])
                CellKind.TRUTH_VALUE -> column.addTruthValue(row, numbers[i])
                CellKind.ROUNDED -> column.addRounded(row, numbers[i])
                CellKind.DECIMAL_COMMA -> column.addDecimalComma(row, numbers[i], line)
                else -> column.addText(row, bytes, starts[i], ends[i], line)
            }
        }
    }
}
