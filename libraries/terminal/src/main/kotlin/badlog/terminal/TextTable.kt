package badlog.terminal

/**
 * Lines of cells in aligned columns, two spaces apart, for a terminal.
 *
 * @param columns the columns, in order; if none has a title, there is no line of titles.
 * @param width the maximum width of a line, in columns of the terminal: the last cell is broken into lines, and if that leaves it
 *   too narrow, the widest others are shortened.
 * @param shortens false for readers that need all of each cell, such as other programs: columns are then never shortened.
 */
class TextTable(private val columns: List<Column>, private val width: Int = Int.MAX_VALUE, private val shortens: Boolean = true) {
    /**
     * The format of a column.
     *
     * @property title its heading.
     * @property most its maximum width; longer cells lose their middle.
     * @property isNumber whether it is aligned to the right.
     */
    class Column(val title: String, val most: Int = Int.MAX_VALUE, val isNumber: Boolean = false)

    /** Returns the titles, then the lines of each of [rows]; columns are as wide as their widest cell. */
    fun lines(rows: List<List<String>>): List<List<String>> {
        val titles = columns.map { it.title }
        val all = (if (titles.all { it.isEmpty() }) emptyList() else listOf(titles)) + rows.map { cells -> cells.map(::printable) }
        val widest = columns.indices.map { i -> all.maxOfOrNull { displayWidth(it[i]) } ?: 0 }
        val widths = if (shortens) columns.zip(widest) { column, cell -> minOf(column.most, cell) } else widest
        return all.map { lines(it, fitting(widths)) }
    }

    /** Returns a single line when the others are not known yet: columns have their maximum width. */
    fun line(cells: List<String>): String = lines(cells.map(::printable), columns.map { it.most }).single()

    /** Returns the titles, for lines made by [line]. */
    fun titles(): String = line(columns.map { it.title })

    private fun fitting(wanted: List<Int>): List<Int> {
        if (width == Int.MAX_VALUE) return wanted
        val widths = wanted.toMutableList()
        val last = widths.lastIndex
        fun excess() = widths.sum() + GAP.length * last - width
        widths[last] = (widths[last] - maxOf(0, excess())).coerceAtLeast(minOf(MIN_LAST, widths[last]))
        while (excess() > 0) widths[(0 until last).maxBy { widths[it] }]--
        return widths
    }

    private fun lines(cells: List<String>, widths: List<Int>): List<String> {
        val last = cells.lastIndex
        val first = (0 until last).joinToString("") { set(it, fitting(cells[it], widths[it]), widths[it]) + GAP }
        val texts = if (width == Int.MAX_VALUE) listOf(fitting(cells[last], widths[last])) else broken(cells[last], widths[last])
        return texts.mapIndexed { index, text ->
            ((if (index == 0) first else " ".repeat(displayWidth(first))) + set(last, text, widths[last])).trimEnd()
        }
    }

    private fun fitting(text: String, width: Int) = if (shortens) shortened(text, width) else text

    private fun set(column: Int, text: String, width: Int): String {
        val blanks = " ".repeat(maxOf(0, width - displayWidth(text)))
        return if (columns[column].isNumber) blanks + text else text + blanks
    }

    companion object {
        /** Returns [text] shortened in the middle so that it takes [most] columns of a terminal. */
        fun shortened(text: String, most: Int): String {
            if (displayWidth(text) <= most) return text
            val end = (most - 1) * 3 / 4
            return startOf(text, most - 1 - end) + "…" + endOf(text, end)
        }

        private const val MIN_LAST = 30
        private const val GAP = "  "
    }
}

private fun broken(text: String, width: Int): List<String> {
    val lines = ArrayList<String>()
    var rest = text
    while (displayWidth(rest) > width) {
        // A character that is wider than the line still gets its own line.
        val most = startOf(rest, width).ifEmpty { rest.take(Character.charCount(rest.codePointAt(0))) }
        val space = rest.lastIndexOf(' ', most.length)
        val end = if (space > most.length / 2) space else most.length
        lines += rest.substring(0, end)
        rest = rest.substring(end).trimStart()
    }
    lines += rest
    return lines
}
