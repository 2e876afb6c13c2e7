package badlog.viewer.shown.table

import badlog.core.analysis.GraphSeries
import badlog.core.analysis.LogView
import badlog.core.analysis.Span
import badlog.core.recording.Topic
import badlog.core.recording.TopicKind

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
