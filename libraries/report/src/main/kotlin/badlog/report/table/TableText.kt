package badlog.report.table

import badlog.expression.Quantity
import badlog.files.terminal.TextTable
import badlog.report.cell
import badlog.report.hookTexts
import badlog.report.plain
import badlog.report.shortNames
import badlog.report.undefinedTexts

/**
 * Returns [rows] of [table] for a terminal of [width] columns. Each included log is a line; values that do not fit beside each other follow
 * in more lines below.
 */
fun tableText(table: MatchTable, rows: List<TableRow>, width: Int = Int.MAX_VALUE): String {
    val included = includedIn(rows)
    val names = shortNames(included.map { it.file })
    val units = unitsOf(table, included)
    val topics = TopicColumn.of(included)
    val hooks = HookColumn.of(included)
    val columns = listOf(TextTable.Column("Match"), TextTable.Column("File")) + table.by.map { TextTable.Column(it) } +
        table.questions.mapIndexed { i, question -> TextTable.Column(titled(question, units[i]), isNumber = true) } +
        topics.map { TextTable.Column(titled(it.title, it.unit), isNumber = true) } +
        hooks.map { column -> TextTable.Column(column.title, isNumber = included.all { isNumber(column.textIn(it)) }) }
    val lines = included.map { row ->
        val file = names.getValue(row.file)
        listOf(row.title ?: file, file) + row.headers +
            row.cells.mapIndexed { i, cell -> textOf(cell, isUnitInTitle = units[i].isNotEmpty()) } +
            topics.map { column -> column.cellIn(row)?.let { textOf(it, isUnitInTitle = column.unit.isNotEmpty()) } ?: UNKNOWN } +
            hooks.map { it.textIn(row) ?: UNKNOWN }
    }
    return TextTable(columns, width, repeated = NAMES).text(lines).joinToString("\n")
}

/** Returns [rows] of [table] as CSV (RFC 4180): exact numbers, and an empty cell for none. */
fun tableCsv(table: MatchTable, rows: List<TableRow>): String {
    val included = includedIn(rows)
    val units = unitsOf(table, included)
    val topics = TopicColumn.of(included)
    val hooks = HookColumn.of(included)
    val head = listOf("Match", "File") + table.by + table.questions.mapIndexed { i, question -> titled(question, units[i]) } +
        topics.map { titled(it.title, it.unit) } + hooks.map { it.title }
    val lines = included.map { row ->
        listOf(row.title.orEmpty(), row.file.path.toString()) + row.headers + row.cells.map { plain(it.value) } +
            topics.map { column -> plain(column.cellIn(row)?.value ?: Double.NaN) } +
            hooks.map { it.textIn(row).orEmpty() }
    }
    return (listOf(head) + lines).joinToString("") { line -> line.joinToString(",", postfix = "\r\n", transform = ::cell) }
}

/** Returns the failures of virtual topics and hooks with their reasons, each as a sentence or more. */
fun notesOf(rows: List<TableRow>): List<String> =
    undefinedTexts(includedIn(rows).map { it.undefined }) + hookTexts(rows.flatMap { row -> row.hookFailures.map { it to row.file } })

private fun includedIn(rows: List<TableRow>) = rows.filter { it.unreadable == null && it.isWanted }

/** A column of a topic's statistic in [rows]; [unit] is empty if it has none or several. */
private class TopicColumn(rows: List<TableRow>, val title: String) {
    private val cells = rows.mapNotNull { row -> row.topics.find { it.title == title }?.let { row to it.cell } }.toMap()
    val unit: String = cells.values.filter { !it.value.isNaN() }.map { it.unit }.distinct().singleOrNull().orEmpty()

    fun cellIn(row: TableRow): TableCell? = cells[row]

    companion object {
        fun of(rows: List<TableRow>): List<TopicColumn> {
            val topics = rows.flatMap { row -> row.topics.map { it.topic } }.distinct().withIndex().associate { (place, name) ->
                name to
                    place
            }
            val titles = rows.flatMap { it.topics }.sortedBy { topics.getValue(it.topic) }.map { it.title }.distinct()
            return titles.map { TopicColumn(rows, it) }
        }
    }
}

/** Returns the unit of each column; empty if it has none or several. */
private fun unitsOf(table: MatchTable, rows: List<TableRow>): List<String> = table.questions.indices.map { column ->
    rows.mapNotNull { it.cells.getOrNull(column)?.takeIf { cell -> !cell.value.isNaN() }?.unit }.distinct().singleOrNull().orEmpty()
}

private fun titled(question: String, unit: String) = if (unit.isEmpty()) question else "$question ($unit)"

private fun isNumber(text: String?) = text == null || text.toDoubleOrNull() != null

private fun textOf(cell: TableCell, isUnitInTitle: Boolean): String = when {
    cell.word.isNotEmpty() -> cell.word
    cell.value.isNaN() -> UNKNOWN
    else -> Quantity("", cell.value, if (isUnitInTitle) "" else cell.unit, Double.NaN).text
}

private const val UNKNOWN = "–"

/** The number of columns that name the log of a row. */
private const val NAMES = 2
