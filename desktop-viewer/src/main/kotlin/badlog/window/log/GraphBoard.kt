package badlog.window.log

import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.BoardHistory
import badlog.viewer.choices.board.fittedTo
import badlog.viewer.choices.board.mergedWith
import badlog.viewer.choices.board.titleOf
import badlog.viewer.state.BoardAction
import badlog.viewer.state.Request
import badlog.viewer.state.Store

/**
 * The graphs that the window shows, from top to bottom, with their history. Use it only on the window's thread.
 *
 * @param store has them.
 * @param isDrawn returns whether the open log can draw the line of a name; graphs without any such line stay on the board, and are not
 * shown.
 */
internal class GraphBoard(private val store: Store, private val isDrawn: (String) -> Boolean = { true }) {
    /** All graphs, also those that the open log cannot draw, with their history. */
    val history: BoardHistory by derivedStateOf { store.state.board }

    /**
     * Each graph added to show a finding, in its original form, except those that a person keeps: undoing also brings back those of
     * previous findings.
     */
    private var added: Set<BoardGraph> by mutableStateOf(emptySet())

    /** The graphs that are shown. Composables that draw them are recomposed when they change. */
    val state: Board by derivedStateOf {
        val whole = history.now
        drawn(whole).takeIf { it != whole } ?: whole
    }

    /** All graphs that a person arranged, also those that the open log cannot draw. */
    val arranged: Board get() = Board(history.now.graphs - added)

    /** Whether there is something to undo. */
    val canUndo: Boolean get() = history.canUndo

    /** Whether something undone can be done again. */
    val canRedo: Boolean get() = history.canRedo

    /** The graphs that were put on top to show a finding, unless a person has changed them. */
    val evidence: Board get() = ofEvidence.let { ids -> Board(state.graphs.filter { it.id in ids }) }

    private val ofEvidence: Set<Int> get() = history.now.graphs.filter { it in added }.mapTo(HashSet()) { it.id }

    /** The graph to scroll to; null if it is visible. */
    var wanted: Int? by mutableStateOf(null)
        private set

    /** The ids of the graphs of which at least half is visible; null while none is shown at all. */
    var inSight: Set<Int>? = null

    /** The id of the graph that the pointer was last over; keys apply to that. */
    var pointed: Int? = null

    /** The graph that a key has just moved: until the pointer moves, keys go on with it, whatever is below the pointer now. */
    private var moved: Int? = null

    /** The shown graphs that a person arranged, without those that were put on top to show a finding. */
    val kept: Board get() = ofEvidence.let { ids -> Board(state.graphs.filter { it.id !in ids }) }

    /** The graph that keys apply to: the one just moved, the one last pointed at, or else the first visible one; null if there are none. */
    val current: BoardGraph?
        get() = state.graphs.find { it.id == moved } ?: state.graphs.find { it.id == pointed }
            ?: state.graphs.find { graph -> inSight?.let { graph.id in it } == true }
            ?: state.graphs.firstOrNull()

    /** Returns the title of [graph], which no other graph has. */
    fun titleOf(graph: BoardGraph): String = state.titleOf(graph)

    /** Changes the shown graphs by [transition]; [undo] restores the previous ones. */
    fun change(transition: Board.() -> Board) = take(history.changed(state.transition(), state))

    /** Returns whether what is shown is what the open log can draw of [board]. */
    fun shows(board: Board): Boolean = state.showsSame(drawn(board))

    /** Shows [board] instead of all graphs; [undo] restores the previous ones. */
    fun changeAll(board: Board) = take(history.changed(board))

    /** Takes back the change from the graphs [before] to [after]; what was changed since stays. */
    fun takeBack(before: Board, after: Board) = take(history.changed(before, after))

    /** Changes the graphs by [change], also those that [undo] restores. */
    fun changeEverywhere(change: Board.() -> Board) {
        added = Board(added.toList()).change().graphs.toSet()
        show(history.everywhere(change))
    }

    /** Shows what another window has changed of the arranged graphs, which are [stored] now and were [read] by this one. */
    fun follow(stored: Board, read: Board) {
        show(history.mergedWith(stored, read))
    }

    /** Scrolls to what has changed, and to the graph that a key has moved, if it is out of sight. */
    fun follow(change: Request.Graphs) {
        val seen = inSight
        change.moved?.let { moved = it }
        if (seen == null) return
        // Nobody looks for graphs added outside the visible part, so scroll to the first of them. If all are new, that is the top.
        val before = change.before?.graphs?.associateBy { it.id }
        val added = state.graphs.filter { graph -> before != null && before[graph.id].let { it == null || it.lines.size < graph.lines.size } }
        val first = change.moved ?: added.firstOrNull()?.id?.takeIf { added.size < state.graphs.size }
        if (first != null && first !in seen) goTo(first)
    }

    private fun take(changed: BoardHistory) = store.send(BoardAction.Take(changed))

    /** Shows [board] instead, as for another log, without a history. */
    fun replace(board: Board) {
        added = emptySet()
        show(history.begunWith(board))
    }

    /** Shows [board] instead of the graphs that a person arranged, without a history; those that show a finding stay above it. */
    fun replaceKept(board: Board) {
        val first = (board.graphs.maxOfOrNull { it.id } ?: 0) + 1
        val shown = evidence.graphs.mapIndexed { i, graph -> graph.copy(id = first + i) }
        added = shown.toSet()
        show(history.begunWith(Board(shown + board.graphs)))
    }

    /**
     * Shows [board] instead unless a person has changed something: graphs in it that are new are there to show a finding.
     */
    fun beginWith(board: Board) {
        if (canUndo) return
        val ids = state.graphs.associate { it.lines to it.id }
        val known = Board(drawn(board).graphs.map { it.copy(id = ids[it.lines] ?: it.id) })
        added = known.graphs.filterNot { it.lines in ids }.toSet()
        show(history.begunWith(known.mergedWith(history.now, state)))
    }

    /** Undoes the last change. */
    fun undo() = take(history.undone())

    /** Redoes what [undo] undid. */
    fun redo() = take(history.redone())

    /** Removes the [current] graph; one that is there to show a finding is kept instead. */
    fun togglePin() {
        val graph = current ?: return
        if (isEvidence(graph.id)) keep(graph.id) else change { without(graph.id) }
    }

    /** Records that the pointer was moved. */
    fun pointerMoved() {
        moved = null
    }

    /**
     * Shows the graphs of [board] above all others, replacing those of the previous finding, except graphs that a person has changed
     * since.
     */
    fun showEvidence(board: Board) {
        if (!evidence.showsSame(board)) {
            val others = kept.graphs
            val first = (history.now.graphs.maxOfOrNull { it.id } ?: 0) + 1
            val graphs = board.graphs.mapIndexed { i, graph -> graph.copy(id = first + i) }
            val known = history.now.graphs.mapTo(HashSet()) { it.id }
            show(history.changed(Board(graphs + others), state))
            added = added + history.now.graphs.filter { it.id !in known }
        }
        evidence.graphs.firstOrNull()?.let { wanted = it.id }
    }

    /** Returns whether graph [id] is there only to show a finding. */
    fun isEvidence(id: Int): Boolean = evidence.graphs.any { it.id == id }

    /** Keeps graph [id], which shows a finding, or all of them for null: they then count as arranged by a person. */
    fun keep(id: Int? = null) {
        added = added - history.now.graphs.filter { id == null || it.id == id }.toSet()
    }

    /** Goes to graph [id]; null if it is visible. */
    fun goTo(id: Int?) {
        wanted = id
    }

    private fun drawn(board: Board) = board.fittedTo(isThere = isDrawn).board

    private fun show(changed: BoardHistory) = store.send(BoardAction.Show(changed))
}
