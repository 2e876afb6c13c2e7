package badlog.core.bag

import badlog.core.text.QUOTE

/** Copies the cells that [splitter] found in a damaged or quoted row into [cells], in the form that [RowScanner] uses. */
internal class CellCopy(
    private val cells: RowCells,
    private val splitter: RowSplitter,
    private val reader: CellReader,
    private val columns: Array<ColumnBuilder>,
) {
    /** The bytes of the row's text cells, unescaped; the starts and ends of cells are indices into it. */
    var text = ByteArray(256)
        private set
    private var textLength = 0

    /**
     * Copies the row's first [count] cells, unescaped if [undouble]. The other cells of the row become empty; cells that the splitter found
     * beyond the row's width are dropped.
     */
    fun take(bytes: ByteArray, undouble: Boolean, count: Int) {
        textLength = 0
        for (i in 0 until cells.columns) {
            if (i >= count) {
                cells.kinds[i] = CellKind.EMPTY
                cells.numbers[i] = Double.NaN
            } else {
                takeCell(i, bytes, undouble && splitter.quoted[i])
            }
        }
    }

    private fun takeCell(i: Int, bytes: ByteArray, undouble: Boolean) {
        val start = splitter.starts[i]
        val end = splitter.ends[i]
        if (splitter.quoted[i] && columns[i].readsDecimalComma && reader.readWithDecimalComma(bytes, start, end)) {
            cells.kinds[i] = CellKind.DECIMAL_COMMA
        } else {
            cells.kinds[i] = reader.read(bytes, start, end)
        }
        cells.numbers[i] = reader.number
        cells.starts[i] = textLength
        if (cells.kinds[i] == CellKind.TEXT) copyText(bytes, start, end, undouble)
        cells.ends[i] = textLength
    }

    private fun copyText(bytes: ByteArray, from: Int, until: Int, undouble: Boolean) {
        if (textLength + until - from > text.size) text = text.copyOf(maxOf(text.size * 2, textLength + until - from))
        var at = from
        while (at < until) {
            text[textLength++] = bytes[at]
            at += if (undouble && bytes[at].toInt() == QUOTE) 2 else 1
        }
    }
}
