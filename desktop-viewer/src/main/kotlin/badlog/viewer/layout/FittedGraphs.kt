package badlog.viewer.layout

import badlog.analysis.Span
import badlog.plot.board.Board
import badlog.viewer.recording.OpenRecording

/**
 * The graphs of a layout as one recording can show them.
 *
 * @property graphs those that have at least one line there.
 * @property missing the signals that the recording lacks, each once.
 * @property dropped the titles of the graphs without any line there.
 */
internal class FittedGraphs(val graphs: Board, val missing: List<String>, val dropped: List<String>) {
    /** What is hidden, in a sentence for the person; null for nothing. */
    val sentence: String?
        get() {
            if (missing.isEmpty()) return null
            val names = missing.take(MAX_NAMES).joinToString { "“${it.take(MAX_NAME_LENGTH)}”" }
            val more = if (missing.size > MAX_NAMES) " and ${missing.size - MAX_NAMES} more" else ""
            return when (dropped.size) {
                0 -> "Topics not in this log: $names$more."
                1 -> "1 graph hidden: topics not in this log ($names$more)."
                else -> "${dropped.size} graphs hidden: topics not in this log ($names$more)."
            }
        }

    private companion object {
        const val MAX_NAMES = 3
        const val MAX_NAME_LENGTH = 60
    }
}

/**
 * Fits [board] to [recording]. A graph of which nothing is known, as one without lines, is dropped. What a formula does not make
 * there is not missing: the list of topics says why.
 */
internal fun fitted(board: Board, recording: OpenRecording): FittedGraphs {
    val missing = LinkedHashSet<String>()
    val defined = recording.formulas.mapNotNullTo(HashSet()) { it.name }
    val dropped = ArrayList<String>()
    val specs = board.graphs.mapIndexedNotNull { i, graph ->
        val (known, unknown) = graph.lines.partition { recording.signal(it) != null }
        missing += unknown - defined
        if (known.isEmpty()) dropped += graph.title
        graph.copy(id = i + 1, lines = known).takeIf { known.isNotEmpty() }
    }
    return FittedGraphs(Board(specs), missing.toList(), dropped)
}

/** [span] as the window knows it; null where it is none. */
internal fun spanOf(span: LayoutSpan): Span? =
    if (span.from < span.to && span.from.isFinite() && span.to.isFinite()) Span(span.from, span.to) else null
