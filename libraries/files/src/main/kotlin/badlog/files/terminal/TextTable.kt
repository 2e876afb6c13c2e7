package badlog.files.terminal

/**
 * Lines of cells in aligned columns, two spaces apart, for a terminal.
 *
 * @param columns the columns, in order; if none has a title, the line of titles is left out.
 * @param width the maximum width of a line, in columns of the terminal: the last cell is broken into lines, and if that leaves it too narrow, the
 *   widest others are shortened, but never values.
 * @param shortens false for readers that need all of each cell, such as other programs: columns are then never shortened.
 * @param repeated the number of columns at the beginning that identify a row: they are repeated in each of the [blocks].
 */
public class TextTable(
    private val columns: List<Column>,
    private val width: Int = Int.MAX_VALUE,
    private val shortens: Boolean = true,
    private val repeated: Int = 0,
) {
    /**
     * The format of a column.
     *
     * @property title its heading.
     * @property most its maximum width; longer cells lose their middle.
     * @property isNumber whether it is aligned to the right.
     * @property isWhole whether its cells are values, which are never shortened; its heading may be.
     */
    public class Column(
        public val title: String,
        public val most: Int = Int.MAX_VALUE,
        public val isNumber: Boolean = false,
        public val isWhole: Boolean = isNumber,
    )

    /** Returns the titles, then the lines of each of [rows]; columns are as wide as their widest cell. */
    public fun lines(rows: List<List<String>>): List<List<String>> {
        val cells = rows.map { row -> row.map(::printable) }
        val titles = columns.map { it.title }
        val all = (if (titles.all { it.isEmpty() }) emptyList() else listOf(titles)) + cells
        val widest = columns.indices.map { i -> all.maxOfOrNull { displayWidth(it[i]) } ?: 0 }
        val wanted = columns.zip(widest) { column, cell -> if (shortens && !column.isWhole) minOf(column.most, cell) else cell }
        val widths = fitting(wanted, leastWidths(cells, MIN_NAME, MIN_TITLE))
        return all.map { lines(it, widths) }
    }

    /**
     * Returns the lines of [rows] in one block, or in several if the columns do not fit beside each other with readable headings. Each
     * block has some of the columns, and the same lines as [lines].
     */
    public fun blocks(rows: List<List<String>>): List<List<List<String>>> {
        val least = leastWidths(rows.map { row -> row.map(::printable) }, (width / NAMES).coerceIn(MIN_NAME, READABLE), READABLE)
        val groups = ArrayList<ArrayList<Int>>()
        val first = (0 until repeated).toList()
        fun fits(group: List<Int>) = group.sumOf { least[it] } + GAP.length * (group.size - 1) <= width
        for (column in repeated until columns.size) {
            val last = groups.lastOrNull()
            if (last != null && fits(last + column)) last += column else groups += ArrayList(first + column)
        }
        return groups.ifEmpty { listOf(first) }.map { group ->
            TextTable(group.map { columns[it] }, width, shortens).lines(rows.map { row -> group.map { row[it] } })
        }
    }

    /** Returns all lines of the [blocks] of [rows], with an empty one between blocks. */
    public fun text(rows: List<List<String>>): List<String> = blocks(rows).flatMapIndexed { index, block ->
        (if (index == 0) emptyList() else listOf("")) + block.flatten()
    }

    /**
     * Returns [cells] as one line of a table with other lines that are not known yet. Each column gets its maximum width, or less if the
     * line would be too wide.
     */
    public fun line(cells: List<String>): String = cells.map(::printable).let { all ->
        val wanted = columns.mapIndexed { i, column -> if (column.isWhole) maxOf(column.most, displayWidth(all[i])) else column.most }
        lines(all, fitting(wanted, leastWidths(listOf(all), MIN_NAME, MIN_TITLE))).single()
    }

    /** Returns the titles, for lines made by [line]. */
    public fun titles(): String = line(columns.map { it.title })

    /** Returns the least width of each column of [rows]. It is its values' width, up to [name] for names, up to [heading] for titles. */
    private fun leastWidths(rows: List<List<String>>, name: Int, heading: Int): List<Int> = columns.mapIndexed { i, column ->
        val widest = rows.maxOfOrNull { displayWidth(it[i]) } ?: 0
        val title = displayWidth(column.title)
        when {
            column.isWhole -> maxOf(widest, minOf(title, heading))
            i == columns.lastIndex -> minOf(MIN_LAST, rows.maxOfOrNull { row -> row[i].split(' ').maxOf(::displayWidth) } ?: 0)
            else -> minOf(name, maxOf(widest, title))
        }
    }

    private fun fitting(wanted: List<Int>, least: List<Int>): List<Int> {
        if (width == Int.MAX_VALUE) return wanted
        val widths = wanted.toMutableList()
        val last = widths.lastIndex
        fun excess() = widths.sum() + GAP.length * last - width
        fun shrinkLast(to: Int) {
            widths[last] = (widths[last] - maxOf(0, excess())).coerceAtLeast(minOf(to, widths[last]))
        }
        // Values are not broken into lines, so only the heading above them can become narrower.
        val breaksLast = !columns[last].isWhole
        if (breaksLast) shrinkLast(maxOf(MIN_LAST, least[last]))
        val others = if (breaksLast) 0 until last else 0..last
        while (excess() > 0) {
            val widest = others.filter { widths[it] > least[it] }.maxByOrNull { widths[it] } ?: break
            widths[widest]--
        }
        if (breaksLast) shrinkLast(least[last])
        return widths
    }

    private fun lines(cells: List<String>, widths: List<Int>): List<String> {
        val last = cells.lastIndex
        val first = (0 until last).joinToString("") { set(it, fitting(cells[it], widths[it]), widths[it]) + GAP }
        val isOneLine = width == Int.MAX_VALUE || columns[last].isWhole
        val texts = if (isOneLine) listOf(fitting(cells[last], widths[last])) else broken(cells[last], widths[last])
        return texts.mapIndexed { index, text ->
            ((if (index == 0) first else " ".repeat(displayWidth(first))) + set(last, text, widths[last])).trimEnd()
        }
    }

    private fun fitting(text: String, width: Int) = if (shortens) shortened(text, width) else text

    private fun set(column: Int, text: String, width: Int): String {
        val blanks = " ".repeat(maxOf(0, width - displayWidth(text)))
        return if (columns[column].isNumber) blanks + text else text + blanks
    }

    public companion object {
        /** Returns [text] shortened in the middle so that it takes [most] columns of a terminal. */
        public fun shortened(text: String, most: Int): String {
            if (displayWidth(text) <= most) return text
            val end = (most - 1) * 3 / 4
            return startOf(text, most - 1 - end) + "…" + endOf(text, end)
        }

        private const val MIN_LAST = 30
        private const val MIN_NAME = 8
        private const val MIN_TITLE = 4

        /** A heading of this width can still be read, and so can a name. */
        private const val READABLE = 18

        /** The number of names that share a line if there is little room. */
        private const val NAMES = 6
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
