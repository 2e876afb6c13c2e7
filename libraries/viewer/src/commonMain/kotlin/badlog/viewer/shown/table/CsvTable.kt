package badlog.viewer.shown.table

import badlog.core.analysis.GraphSeries
import badlog.core.analysis.LogView
import badlog.core.analysis.Span
import badlog.core.analysis.periodicTimes
import badlog.core.recording.Topic
import badlog.core.recording.TopicKind
import kotlin.math.floor

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

/**
 * A [CsvTable] in the making. Each [step] handles one topic, because a log may have thousands of them, with a million samples each.
 * Between steps, a page can respond and a task can be canceled.
 */
class CsvDraft private constructor(private val view: LogView, private val span: Span?, private val events: List<Topic>) {
    private val steps = ArrayList<() -> Unit>()
    private var next = 0
    private val lines = ArrayList<GraphSeries>()
    private val columns = ArrayList<CsvColumn>()
    private var made: CsvTable? = null

    /** The range of the rows, if the log has none of its own; null if it is empty. */
    private val range: Span? = view.xAxis.range?.let { whole ->
        val from = maxOf(span?.from ?: whole.start, whole.start)
        val to = minOf(span?.to ?: whole.endInclusive, whole.endInclusive)
        if (from <= to) Span(from, to) else null
    }
    private var densest: GraphSeries? = null
    private var mostSamples = 0

    /** The finished fraction of the work, from 0 to 1. */
    val share: Double get() = next.toDouble() / steps.size

    /** The table, once [step] has returned false. */
    val table: CsvTable get() = checkNotNull(made)

    /** Does the next part of the work, and returns whether there was one. */
    fun step(): Boolean {
        if (next == steps.size) return false
        steps[next++]()
        return true
    }

    internal fun finished(): CsvTable {
        do {
            val isMore = step()
        } while (isMore)
        return table
    }

    private fun add(line: GraphSeries) {
        lines += line
        if (view.xAxis.positions.isNotEmpty()) return
        val samples = range?.let { line.data.x.count(it::contains) } ?: 0
        if (densest == null || samples > mostSamples) {
            densest = line
            mostSamples = samples
        }
    }

    /** Lays out the rows, which takes one step, and then makes a column per step. */
    private fun layRows() {
        val positions = view.xAxis.positions
        val hasRows = positions.isNotEmpty()
        val (times, remark) = if (hasRows) positions to "" else timesFor()
        val rows = if (hasRows && span != null) rowsWithin(positions, span) else times.indices
        for (line in lines) {
            steps += {
                columns += if (!hasRows || line.isDerived || line.topic.times != null) heldColumn(line, times) else loggedColumn(line.topic)
            }
        }
        for (topic in events) steps += { columns += eventColumn(view, topic, times) }
        steps += { made = CsvTable(view.xAxis.title, times, rows, columns, remark) }
    }

    private fun timesFor(): Pair<DoubleArray, String> {
        val range = range ?: return DoubleArray(0) to ""
        val samples = densest?.data?.x ?: DoubleArray(0)
        return TableRows.of(range, lines.size, densest?.topic?.name, samples).run { times to remark }
    }

    companion object {
        /** Begins a table of all topics of [view] that have samples, within [span]; null for all rows. */
        fun ofAll(view: LogView, span: Span? = null): CsvDraft {
            val topics = view.recording.topics.filter { it !== view.xAxis.topic }
            val (events, others) = topics.partition { it.kind == TopicKind.EVENT || "log" in it.attributes }
            return CsvDraft(view, span, events).apply {
                for (topic in others) {
                    steps += { view.seriesOf(topic).let { if (it.states != null || it.topic.samples.isNotEmpty()) add(it) } }
                }
                steps += ::layRows
            }
        }

        /** Begins a table of [lines], which belong to [view], within [span]; null for all rows. */
        fun of(view: LogView, span: Span?, lines: List<GraphSeries>): CsvDraft = CsvDraft(view, span, emptyList()).apply {
            for (line in lines) steps += { add(line) }
            steps += ::layRows
        }
    }
}

/**
 * The rows of a table for topics that do not share rows.
 *
 * @property remark the way they were made, to append to a sentence.
 */
class TableRows(val times: DoubleArray, val remark: String) {
    companion object {
        /**
         * Makes rows in [range] for [columns] topics: one every 20 ms, as often as a robot's program runs. If [samples], the times of the
         * topic [densest], are more, makes a row at each of them.
         */
        fun of(range: Span, columns: Int, densest: String?, samples: DoubleArray): TableRows {
            // Many topics over many hours would be more than any spreadsheet can open, and need more memory than there is.
            val most = MAX_CELLS / (columns + 1)
            val period = generateSequence(PERIOD) { it * 2 }.first { range.width / it < most }
            val periodic = floor(range.width / period + ROUNDING).toInt() + 1
            val own = samples.filter { it in range }.distinct().sorted()
            if (own.size > periodic && own.size < most) return TableRows(own.toDoubleArray(), ", one at each sample of “$densest”$HELD")
            return TableRows(periodicTimes(range.from, period, periodic), ", one every ${(period * 1000).toInt()} ms$HELD")
        }

        private const val HELD = ", each with the last values before it"

        /** The time between two rows, in seconds. */
        private const val PERIOD = 0.02
        private const val MAX_CELLS = 40e6

        // The tolerance, in periods, for the last step of a period that divides the range.
        private const val ROUNDING = 1e-9
    }
}

/** Returns the rows from the first to the last in [span]. Rows between them belong to it even if x is missing or goes backward. */
fun rowsWithin(positions: DoubleArray, span: Span): IntRange {
    val first = positions.indexOfFirst { it in span }
    return if (first < 0) IntRange.EMPTY else first..positions.indexOfLast { it in span }
}
