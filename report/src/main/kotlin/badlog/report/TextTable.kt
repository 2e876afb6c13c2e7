package badlog.report

/**
 * Columns of texts, each as wide as need be, and the line at most [width] wide: the last column is broken into lines, and where that
 * leaves it too narrow the widest others are cut. [titles] is empty for a table without.
 */
internal class TextTable(private val titles: List<String>, private val width: Int = WIDTH) {
    private val rows = ArrayList<List<String>>()

    fun add(cells: List<String>) {
        rows += cells.map { cell -> cell.map { if (it.isISOControl()) ' ' else it }.joinToString("") }
    }

    override fun toString(): String {
        val all = if (titles.isEmpty()) rows else listOf(titles) + rows
        val widths = IntArray(all[0].size) { column -> all.maxOf { it[column].length } }
        val last = widths.size - 1
        fun tooWide() = widths.sum() + GAP.length * last - width
        widths[last] = (widths[last] - maxOf(0, tooWide())).coerceAtLeast(minOf(LEAST_LAST, widths[last]))
        while (tooWide() > 0) widths[(0 until last).maxBy { widths[it] }]--
        return all.joinToString("\n") { cells -> lines(cells, widths) }
    }

    private fun lines(cells: List<String>, widths: IntArray): String {
        val last = widths.size - 1
        val first = (0 until last).joinToString("") { cut(cells[it], widths[it]).padEnd(widths[it]) + GAP }
        return broken(cells[last], widths[last]).mapIndexed { index, line ->
            ((if (index == 0) first else " ".repeat(first.length)) + line).trimEnd()
        }.joinToString("\n")
    }

    private fun cut(text: String, width: Int) = if (text.length <= width) text else text.take(width - 1) + "…"

    private fun broken(text: String, width: Int): List<String> {
        val lines = ArrayList<String>()
        var rest = text
        while (rest.length > width) {
            val space = rest.lastIndexOf(' ', width)
            val end = if (space > width / 2) space else width
            lines += rest.substring(0, end)
            rest = rest.substring(end).trimStart()
        }
        lines += rest
        return lines
    }

    companion object {
        const val WIDTH = 100
        private const val LEAST_LAST = 30
        private const val GAP = "  "
    }
}
