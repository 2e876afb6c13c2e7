package badlog.window.layout

import badlog.core.analysis.Span
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.FittedBoard
import badlog.viewer.choices.board.fittedTo
import badlog.viewer.choices.board.identifiedByLines
import badlog.viewer.choices.board.withFallback
import badlog.viewer.choices.comparison.LogOffsets
import badlog.viewer.state.BoardAction
import badlog.window.compare.ComparedRecordings
import badlog.window.log.CurrentRecording
import badlog.window.log.GraphBoard
import badlog.window.log.OpenRecording
import badlog.window.task.Notices
import java.nio.file.Files
import java.nio.file.Path

/**
 * The graphs that are arranged for a folder, on the board of its open log. Use it only on the window's thread. Graphs that this log cannot
 * draw stay on the board.
 *
 * @param whenStillOpen calls a function as soon as all logs are shown as chosen, unless a person has opened another log by then.
 * @param saved returns the graphs that this window has arranged for the folder of a recording; null for none.
 */
internal class ArrangedGraphs(
    private val current: CurrentRecording,
    private val board: GraphBoard,
    private val notices: Notices,
    private val whenStillOpen: ((OpenRecording) -> Unit) -> Unit,
    private val saved: (OpenRecording) -> Board?,
) {
    /** The initial graphs of the last log for which no graphs were arranged. Null if there was none in this folder. */
    private var begun: Board? = null

    /**
     * Begins with another folder. [open] is the open log in that folder; null for none. Returns true if a person has already changed that
     * log's initial graphs, which then stay instead of the arranged ones.
     */
    fun enter(open: OpenRecording?): Boolean {
        begun = open?.standardGraphs
        if (open == null || saved(open) == null) return false
        if (!board.arranged.showsSame(open.standardGraphs)) return true
        board.replace(begin(open))
        sayMissing(open)
        return false
    }

    /** Returns the initial graphs of [recording], if [arranged] are the graphs of its folder. */
    private fun begin(recording: OpenRecording, arranged: Board? = saved(recording)): Board {
        val all = placed(recording, arranged)
        if (arranged == null) begun = all
        return all
    }

    /** Reports which of the arranged graphs [recording] lacks. */
    private fun sayMissing(recording: OpenRecording) {
        val arranged = saved(recording) ?: return
        val there = fitted(arranged, recording)
        if (there.board.graphs.isNotEmpty()) there.sentence?.let(notices::say)
    }

    /**
     * Shows the graphs for [recording], which was just opened, and again when its formulas are calculated. It may have been read before the
     * formulas of its folder were known. If [isGrowing], the log has just begun, and missing topics are not reported.
     */
    fun show(recording: OpenRecording, isGrowing: Boolean) {
        val first = begin(recording)
        board.replace(first)
        whenStillOpen { open ->
            if (!isGrowing) sayMissing(open)
            if (board.arranged.showsSame(first)) placeAgain(open)
        }
    }

    /**
     * Calls [show], which shows the open log with new rows or calculations. Afterwards, it has the graphs arranged for its folder, or its
     * new initial graphs, unless a person has changed them.
     */
    fun following(show: () -> Unit) {
        val isPlaced = current.recording?.let(::isPlaced) == true
        show()
        if (isPlaced) current.recording?.let(::placeAgain)
    }

    /** Shows [graphs] instead, and reports which of them [open] lacks; for null, shows its initial graphs without arranged ones. */
    fun apply(graphs: Board?, open: OpenRecording) {
        if (graphs == null) return board.send(BoardAction.ShowAll(open.standardGraphs))
        board.send(BoardAction.ShowAll(Board(graphs.graphs.filter { it.lines.isNotEmpty() }).identifiedByLines()))
        fitted(graphs, open).sentence?.let(notices::say)
    }

    /** Returns the graphs to store for the folder that contains [open]; null if none are arranged. */
    fun toStore(open: OpenRecording): Board? = if (isPlaced(open)) saved(open) else board.arranged.orNull(open)

    /** Returns the graphs with which [open] began, before any were arranged for its folder. */
    fun initial(open: OpenRecording): Board = begun ?: open.standardGraphs

    private fun isPlaced(recording: OpenRecording) = board.arranged.showsSame(placed(recording, saved(recording)))

    private fun placed(recording: OpenRecording, arranged: Board?): Board =
        arranged?.withFallback({ recording.standardGraphs.without(arranged) }) { recording.signal(it) != null } ?: recording.standardGraphs

    private fun placeAgain(open: OpenRecording, arranged: Board? = saved(open)) {
        val now = begin(open, arranged)
        if (!board.arranged.showsSame(now)) board.send(BoardAction.BeginBelowEvidence(now))
    }

    private fun Board.orNull(open: OpenRecording) = takeUnless { it.showsSame(open.standardGraphs) }

    private fun Board.without(other: Board): Board {
        val ids = other.graphs.mapTo(HashSet()) { it.id }
        return Board(graphs.filter { it.id !in ids })
    }
}

/** Fits [board] to [recording]. A formula that fails there does not count as missing: the list of topics says why. */
internal fun fitted(board: Board, recording: OpenRecording): FittedBoard =
    board.fittedTo(excused = recording.formulas.mapNotNullTo(HashSet()) { it.name }) { recording.signal(it) != null }

/** Returns [span] in the window's form; null if it is not valid. */
internal fun spanOf(span: LayoutSpan): Span? =
    if (span.from < span.to && span.from.isFinite() && span.to.isFinite()) Span(span.from, span.to) else null

/** Compares the open recording with the files in [layout] of [folder], as they were aligned; missing files are skipped. */
internal fun ComparedRecordings.restore(layout: LayoutComparison, folder: Path?) {
    fun fileOf(text: String) = pathOf(text, folder)?.toAbsolutePath()?.normalize()
    val files = layout.files.mapNotNull(::fileOf).distinct().filter(Files::isRegularFile)
    val offsets = layout.offsets.entries.mapNotNull { (text, offset) -> fileOf(text)?.let { it to offset } }
    state.checked.filter { it !in files }.forEach(::remove)
    files.filter { it !in state.checked }.forEach(::add)
    change { copy(offsets = LogOffsets(alignmentOf(layout), offsets.toMap())) }
}
