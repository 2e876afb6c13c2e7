package badlog.cli.info

import badlog.cli.text.XTime
import badlog.cli.text.grouped
import badlog.recording.Severity
import badlog.terminal.TextTable
import badlog.terminal.TextTable.Column

/** One line about each log. */
internal object OverviewText {
    private val TABLE = TextTable(
        listOf(
            Column("LOG", 27),
            Column("MATCH", 22),
            Column("LENGTH", 7, isNumber = true),
            Column("SAMPLES", 10, isNumber = true),
            Column("ERRORS", 6, isNumber = true),
        ),
    )

    /** What stands above the lines. */
    fun titles(): String = TABLE.titles()

    /** The line of [summary]. */
    fun line(summary: LogSummary): String = TABLE.line(
        listOf(
            summary.file.toString(),
            summary.view.title.orEmpty(),
            summary.seconds?.let(XTime::clock).orEmpty(),
            grouped(summary.view.recording.sampleCount),
            summary.view.problems.filter { it.severity == Severity.ERROR }.sumOf { it.count }.let { if (it == 0) "" else "$it" },
        ),
    )
}
