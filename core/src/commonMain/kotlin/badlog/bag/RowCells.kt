package badlog.bag

/**
 * The cells of one row between their bytes and their columns. A row is put into the columns only when all of it was read,
 * so a row that turns out to be cut or odd leaves no trace.
 *
 * @property columns how many cells a row has.
 */
internal class RowCells(val columns: Int) {
    /** For each cell its [CellKind]. */
    val kinds = IntArray(columns)

    /** For each cell its number, where it has one. */
    val numbers = DoubleArray(columns)

    /** For each text cell, where its bytes begin, and where they end. */
    val starts = IntArray(columns)
    val ends = IntArray(columns)

    /** Puts the row into the columns as row number [row]; [line] is the line it stands on. */
    fun commit(builders: Array<ColumnBuilder>, row: Int, bytes: ByteArray, line: Int) {
        for (i in builders.indices) {
            val column = builders[i]
            when (kinds[i]) {
                CellKind.NUMBER -> column.addNumber(row, numbers[i])
                CellKind.EMPTY -> column.addEmpty(row)
                CellKind.NOT_FINITE -> column.addNotFinite(row, numbers[i])
                CellKind.TRUTH_VALUE -> column.addTruthValue(row, numbers[i])
                CellKind.DECIMAL_COMMA -> column.addDecimalComma(row, numbers[i], line)
                else -> column.addText(row, bytes, starts[i], ends[i], line)
            }
        }
    }
}
