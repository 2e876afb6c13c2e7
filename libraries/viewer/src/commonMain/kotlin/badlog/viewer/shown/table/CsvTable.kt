package badlog.viewer.shown.table

import badlog.core.analysis.GraphSeries
import badlog.core.analysis.LogView
import badlog.core.analysis.Span

/**
 * A part of a log for a spreadsheet. Its columns are x, then each line with its name and unit, then each topic of events. The
 * rows are the log's; topics with times of their own have in each row the last value at or before it.
 *
 * @property rowCount the number of rows below the titles.
 * @property remark the way the rows were made, to append to a sentence; empty if the log has rows of its own.
 */
class CsvTable internal constructor(
    xTitle: String,
    private val x: DoubleArray,
    private val rows: IntRange,
    private val columns: List<CsvColumn>,
    val remark: String,
) {
    private val titles = listOf(xTitle) + columns.map { it.title }

    val rowCount: Int get() = rows.last + 1 - rows.first

    /**
     * The line of titles. If it is not ASCII, a byte order mark before it marks the text as UTF-8: without it, Excel assumes something
     * else.
     */
    val header: String
        get() {
            val isAscii = titles.all { title -> title.all { it < '\u0080' } }
            return titles.joinToString(",", if (isAscii) "" else "\uFEFF", "\n", transform = ::cellOf)
        }

    /** Returns the lines of [count] rows from [first] on, counted from 0, or of as many as there are. */
    fun text(first: Int, count: Int): String = buildString {
        for (row in rows.first + first until minOf(rows.first + first + count, rows.last + 1)) {
            append(cellOf(x[row]))
            for (column in columns) append(',').append(column.cell(row))
            append('\n')
        }
    }

    companion object {
        /** Returns a table of all topics of [view] that have samples, within [span]; null for all rows. */
        fun ofAll(view: LogView, span: Span? = null): CsvTable = CsvDraft.ofAll(view, span).finished()

        /** Returns a table of [lines], which belong to [view], within [span]; null for all rows. */
        fun of(view: LogView, span: Span?, lines: List<GraphSeries>): CsvTable = CsvDraft.of(view, span, lines).finished()
    }
}
