package badlog.viewer.layout

import badlog.analysis.Span
import badlog.viewer.board.GraphList
import badlog.viewer.board.GraphSpec
import badlog.viewer.board.LineSpec
import badlog.viewer.recording.OpenRecording

/**
 * The graphs of a layout as one recording can show them.
 *
 * @property graphs those that have at least one line there.
 * @property missing the signals that the recording lacks, each once.
 * @property dropped the titles of the graphs without any line there.
 */
internal class FittedGraphs(val graphs: GraphList, val missing: List<String>, val dropped: List<String>) {
    /** What is hidden, in a sentence for the person; null for nothing. */
    val sentence: String?
        get() {
            if (missing.isEmpty()) return null
            val names = missing.take(MOST_NAMES).joinToString { "“${it.take(LONGEST_NAME)}”" }
            val more = if (missing.size > MOST_NAMES) " and ${missing.size - MOST_NAMES} more" else ""
            return when (dropped.size) {
                0 -> "Topics not in this log: $names$more."
                1 -> "1 graph hidden: topics not in this log ($names$more)."
                else -> "${dropped.size} graphs hidden: topics not in this log ($names$more)."
            }
        }

    private companion object {
        const val MOST_NAMES = 3
        const val LONGEST_NAME = 60
    }
}

/**
 * Fits [graphs] to [recording]. A graph of which nothing is known, as one without lines, is dropped. What a formula does not make
 * there is not missing: the list of topics says why.
 */
internal fun fitted(graphs: List<LayoutGraph>, recording: OpenRecording): FittedGraphs {
    val missing = LinkedHashSet<String>()
    val defined = recording.formulas.mapNotNullTo(HashSet()) { it.name }
    val dropped = ArrayList<String>()
    val specs = graphs.mapIndexedNotNull { i, graph ->
        val (known, unknown) = graph.lines.distinct().partition { recording.signal(it) != null }
        missing += unknown - defined
        if (known.isEmpty()) dropped += graph.title
        specOf(i + 1, graph, known).takeIf { known.isNotEmpty() }
    }
    return FittedGraphs(GraphList(specs), missing.toList(), dropped)
}

private fun specOf(id: Int, graph: LayoutGraph, signals: List<String>) = GraphSpec(
    id = id,
    title = graph.title,
    lines = signals.map(::LineSpec),
    isFilled = graph.filled,
    includesZero = graph.zero,
    yRange = graph.y?.let(::spanOf),
)

/** [span] as the window knows it; null where it is none. */
internal fun spanOf(span: LayoutSpan): Span? =
    if (span.from < span.to && span.from.isFinite() && span.to.isFinite()) Span(span.from, span.to) else null
