package badlog.cli.text

/**
 * Lines of cells in aligned columns, two blanks apart.
 *
 * @param columns the columns, in their order.
 */
internal class TextTable(private val columns: List<Column>) {
    /**
     * How a column is set.
     *
     * @property title what stands above it.
     * @property most the widest it may be; what is longer loses its middle.
     * @property isNumber whether it is set to the right.
     */
    class Column(val title: String, val most: Int = Int.MAX_VALUE, val isNumber: Boolean = false)

    /** The titles, then [rows], each as one line; columns are as wide as their widest cell. */
    fun lines(rows: List<List<String>>): List<String> {
        val widths = columns.mapIndexed { i, column ->
            minOf(column.most, maxOf(column.title.length, rows.maxOfOrNull { it[i].length } ?: 0))
        }
        return listOf(line(columns.map { it.title }, widths)) + rows.map { line(it, widths) }
    }

    /** One line where the others are not known yet: columns are as wide as they may be. */
    fun line(cells: List<String>): String = line(cells, columns.map { it.most })

    /** The titles, for lines that [line] sets. */
    fun titles(): String = line(columns.map { it.title })

    private fun line(cells: List<String>, widths: List<Int>) = cells.withIndex().joinToString("  ") { (i, cell) ->
        val text = shortened(printable(cell), widths[i])
        if (columns[i].isNumber) text.padStart(widths[i]) else text.padEnd(widths[i])
    }.trimEnd()

    companion object {
        /** [text] without so much of its middle that it is [most] long. */
        fun shortened(text: String, most: Int): String {
            if (text.length <= most) return text
            val end = (most - 1) * 3 / 4
            return text.take(most - 1 - end) + "…" + text.takeLast(end)
        }
    }
}
