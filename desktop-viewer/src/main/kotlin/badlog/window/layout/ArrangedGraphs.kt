package badlog.window.layout

import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.identifiedByLines
import badlog.viewer.choices.board.orAlso
import badlog.viewer.state.BoardAction
import badlog.window.log.CurrentRecording
import badlog.window.log.GraphBoard
import badlog.window.log.OpenRecording
import badlog.window.task.Notices

/**
 * The graphs that are arranged for a folder, on the board of whichever log of it is open. Those that this log cannot draw stay on the
 * board. Use it only on the window's thread.
 *
 * @param whenStillOpen calls a function as soon as all is shown as it is chosen, unless a person has opened another log by then.
 * @param saved returns the graphs that this window has arranged for the folder of a recording; null for none.
 */
internal class ArrangedGraphs(
    private val current: CurrentRecording,
    private val board: GraphBoard,
    private val notices: Notices,
    private val whenStillOpen: ((OpenRecording) -> Unit) -> Unit,
    private val saved: (OpenRecording) -> Board?,
) {
    /** What the last log began with for which no graphs were arranged; null if there was none in this folder. */
    private var begun: Board? = null

    /** What the open log began with besides arranged graphs of which it can draw none. */
    private var besides = Board()

    /**
     * Begins with another folder, to which the log [open] belongs; null for none. Returns whether a person has already changed the graphs
     * with which that log began: then it did not begin with those arranged.
     */
    fun enter(open: OpenRecording?): Boolean {
        besides = Board()
        begun = open?.standardGraphs
        if (open == null || saved(open) == null) return false
        if (!board.arranged.showsSame(open.standardGraphs)) return true
        board.replace(begin(open))
        sayMissing(open)
        return false
    }

    /** Returns the graphs with which [recording] begins where [arranged] are those of its folder. */
    private fun begin(recording: OpenRecording, arranged: Board? = saved(recording)): Board {
        val all = placed(recording, arranged)
        if (arranged == null) begun = all
        besides = all.without(arranged ?: all)
        return all
    }

    /** Says which of the arranged graphs [recording] lacks. */
    private fun sayMissing(recording: OpenRecording) {
        val arranged = saved(recording) ?: return
        val there = fitted(arranged, recording)
        if (there.board.graphs.isNotEmpty()) there.sentence?.let(notices::say)
    }

    /**
     * Shows the graphs for [recording], which was just opened, and again when its formulas are calculated: it may have been read before
     * those of its folder were known. If it is a log that has just begun, [isGrowing], nothing is said of what it lacks.
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
     * Calls [show], which shows the open log with what was written or calculated since. Its graphs are still those arranged for its folder,
     * or those with which it begins now, unless a person has changed them.
     */
    fun following(show: () -> Unit) {
        val isPlaced = current.recording?.let(::isPlaced) == true
        show()
        if (isPlaced) current.recording?.let(::placeAgain)
    }

    /** Shows [graphs] instead, and says which of them [open] lacks; for null, those with which it begins if none are arranged. */
    fun apply(graphs: Board?, open: OpenRecording) {
        if (graphs == null) return board.send(BoardAction.ShowAll(open.standardGraphs))
        board.send(BoardAction.ShowAll(Board(graphs.graphs.filter { it.lines.isNotEmpty() }).identifiedByLines()))
        fitted(graphs, open).sentence?.let(notices::say)
    }

    /** Returns the graphs to store for the folder of [open], which is in it; null if none are arranged. */
    fun toStore(open: OpenRecording): Board? = if (isPlaced(open)) saved(open) else board.arranged.orNull(open)

    /**
     * Takes over what other windows have changed: the graphs arranged for the folder of [open] are [stored] now, and were [read] by this
     * window before; null for none. Lines called [removed] are no more. Returns the graphs to store; null if none are arranged.
     */
    fun mergedWith(stored: Board?, read: Board?, removed: Set<String>, open: OpenRecording): Board? {
        val wasPlaced = isPlaced(open)
        val before = read ?: begun ?: open.standardGraphs
        val now = if (stored == read) before else stored ?: open.standardGraphs
        val own = besides.without(before)
        board.send(BoardAction.Merge(Board(now.graphs + own.without(now).graphs), Board(before.graphs + own.graphs)))
        if (removed.isNotEmpty()) board.send(BoardAction.Forget(removed))
        if (!wasPlaced) return board.arranged.orNull(open)
        return board.arranged.without(own).orNull(open).also { placeAgain(open, it) }
    }

    private fun isPlaced(recording: OpenRecording) = board.arranged.showsSame(placed(recording, saved(recording)))

    private fun placed(recording: OpenRecording, arranged: Board?): Board =
        arranged?.orAlso({ recording.standardGraphs.without(arranged) }) { recording.signal(it) != null } ?: recording.standardGraphs

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
