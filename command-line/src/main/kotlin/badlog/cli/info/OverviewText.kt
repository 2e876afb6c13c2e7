package badlog.cli.info

import badlog.cli.console.Console
import badlog.cli.text.LINE_WIDTH
import badlog.cli.text.XTime
import badlog.cli.text.grouped
import badlog.core.recording.Severity
import badlog.files.terminal.TextTable
import badlog.files.terminal.TextTable.Column

/** One line about each log, of [width] columns. */
internal class OverviewText(private val width: Int) {
    private val more = if (width == Console.UNLIMITED) 0 else width - LINE_WIDTH
    private val table = TextTable(
        listOf(
            Column("LOG", LOG + more - more / 3),
            Column("MATCH", MATCH + more / 3),
            Column("LENGTH", 7, isNumber = true),
            Column("SAMPLES", 10, isNumber = true),
            Column("ERRORS", 6, isNumber = true),
        ),
        width,
        shortens = width != Console.UNLIMITED,
    )
    private val rows = ArrayList<List<String>>()

    /** Whether the lines have to wait for the longest name: nothing is shortened for another program. */
    private val waits: Boolean get() = width == Console.UNLIMITED

    /** Returns the line of [summary], below the titles of the columns on the first call. Empty if the line must wait for [rest]. */
    fun add(summary: LogSummary): String {
        val cells = cellsOf(summary)
        rows += cells
        return when {
            waits -> ""
            rows.size == 1 -> table.titles() + "\n" + table.line(cells)
            else -> table.line(cells)
        }
    }

    /** Returns all lines that had to wait; empty if there are none. */
    fun rest(): String = if (waits && rows.isNotEmpty()) table.lines(rows).flatten().joinToString("\n") else ""

    private fun cellsOf(summary: LogSummary) = listOf(
        summary.file.toString(),
        summary.view.title.orEmpty(),
        summary.seconds?.let(XTime::clock).orEmpty(),
        grouped(summary.view.recording.sampleCount),
        summary.view.problems.filter { it.severity == Severity.ERROR }.sumOf { it.count }.let { if (it == 0) "" else "$it" },
    )
}

private const val LOG = 27
private const val MATCH = 22
