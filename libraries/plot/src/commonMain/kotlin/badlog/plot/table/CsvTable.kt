package badlog.plot.table

import badlog.analysis.GraphSeries
import badlog.analysis.LogView
import badlog.analysis.Span
import badlog.analysis.periodicTimes
import badlog.recording.Topic
import badlog.recording.TopicKind
import kotlin.math.floor

/**
 * A part of a log for a spreadsheet: x first, then a column for each line with its name and unit, then one for each topic of events. Rows
 * are those of the log; topics with times of their own have in each row the last value at or before it.
 *
 * @property rowCount the number of rows below the titles.
 * @property remark how the rows were made if the log has none, to append to a sentence; otherwise empty.
 */
public class CsvTable private constructor(
    xTitle: String,
    private val x: DoubleArray,
    private val rows: IntRange,
    private val columns: List<CsvColumn>,
    public val remark: String,
) {
    private val titles = listOf(xTitle) + columns.map { it.title }

    public val rowCount: Int get() = rows.last + 1 - rows.first

    /** The line of titles. A byte order mark before it marks the text as UTF-8 if necessary: without it, Excel assumes something else. */
    public val header: String
        get() = titles.joinToString(
            ",",
            if (titles.all { title ->
                    title.all { it < '\u0080' }
                }
            ) {
                ""
            } else {
                "\uFEFF"
            },
            "\n",
            transform = ::cellOf,
        )

    /** Returns the lines of [count] rows from [first] on, counted from 0, or of as many as there are. */
    public fun text(first: Int, count: Int): String = buildString {
        for (row in rows.first + first until minOf(rows.first + first + count, rows.last + 1)) {
            append(cellOf(x[row]))
            for (column in columns) append(',').append(column.cell(row))
            append('\n')
        }
    }

    public companion object {
        /** Returns a table of each topic of [view] that has samples, within [span]; null for all rows. */
        public fun ofAll(view: LogView, span: Span? = null): CsvTable {
            val topics = view.recording.topics.filter { it !== view.xAxis.topic }
            val (events, others) = topics.partition { it.kind == TopicKind.EVENT || "log" in it.attributes }
            return of(view, span, others.map(view::seriesOf).filter { it.states != null || it.topic.samples.isNotEmpty() }, events)
        }

        /** Returns the same for [lines], some of [view]'s, and [events], topics of it. */
        public fun of(view: LogView, span: Span?, lines: List<GraphSeries>, events: List<Topic> = emptyList()): CsvTable {
            val positions = view.xAxis.positions
            if (positions.isNotEmpty()) {
                val rows = if (span == null) positions.indices else rowsIn(positions, span)
                val columns = lines.map {
                    if (it.isDerived ||
                        it.topic.times != null
                    ) {
                        heldColumn(it, positions)
                    } else {
                        loggedColumn(it.topic)
                    }
                }
                return CsvTable(view.xAxis.title, positions, rows, columns + events.map { eventColumn(view, it, positions) }, "")
            }
            val (times, remark) = timesFor(view, span, lines)
            val columns = lines.map { heldColumn(it, times) } + events.map { eventColumn(view, it, times) }
            return CsvTable(view.xAxis.title, times, times.indices, columns, remark)
        }

        /** Returns the rows from the first to the last in [span]: if x is missing or goes backwards, the rows in between are included. */
        private fun rowsIn(positions: DoubleArray, span: Span): IntRange {
            val first = positions.indexOfFirst { it in span }
            return if (first < 0) IntRange.EMPTY else first..positions.indexOfLast { it in span }
        }

        /**
         * Returns rows for topics that share none: one every 20 ms, as often as a robot's program runs, or one at each sample of a line
         * that has more.
         */
        private fun timesFor(view: LogView, span: Span?, lines: List<GraphSeries>): Pair<DoubleArray, String> {
            val range = view.xAxis.range
            if (range == null) return DoubleArray(0) to ""
            val from = maxOf(span?.from ?: range.start, range.start)
            val to = minOf(span?.to ?: range.endInclusive, range.endInclusive)
            if (!(from <= to)) return DoubleArray(0) to ""
            // Many topics over many hours would be more than any spreadsheet can open.
            val most = MAX_CELLS / (lines.size + 1)
            val period = generateSequence(PERIOD) { it * 2 }.first { (to - from) / it < most }
            val periodic = floor((to - from) / period + ROUNDING).toInt() + 1
            val densest = lines.maxByOrNull { line -> line.data.x.count { it in from..to } }
            val own = densest?.data?.x?.filter { it in from..to }?.distinct()?.sorted().orEmpty()
            if (densest != null && own.size > periodic && own.size < most) {
                return own.toDoubleArray() to ", one at each sample of “${densest.topic.name}”$HELD"
            }
            return periodicTimes(from, period, periodic) to ", one every ${(period * 1000).toInt()} ms$HELD"
        }

        private const val HELD = ", each with the last values before it"

        /** In seconds. */
        private const val PERIOD = 0.02
        private const val MAX_CELLS = 40e6

        // The tolerance, in periods, for the last step of a period that divides the range.
        private const val ROUNDING = 1e-9
    }
}
