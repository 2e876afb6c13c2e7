package badlog.window.log

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.BoardHistory
import badlog.viewer.choices.board.titleOf

/** The graphs that the window shows, from top to bottom, with their history. Use it only on the window's thread. */
internal class GraphBoard {
    /** The graphs with their history. */
    var history by mutableStateOf(BoardHistory())
        private set

    /**
     * Each graph added to show a finding, in its original form, except those that a person keeps: undoing also brings back those of
     * previous findings.
     */
    private var added: Set<BoardGraph> by mutableStateOf(emptySet())

    /** The graphs. Composables that draw them are recomposed when they change. */
    val state: Board get() = history.now

    /** Whether there is something to undo. */
    val canUndo: Boolean get() = history.canUndo

    /** Whether something undone can be done again. */
    val canRedo: Boolean get() = history.canRedo

    /** The graphs that were put on top to show a finding, unless a person has changed them. */
    val evidence: Board get() = Board(state.graphs.filter { it in added })

    /** The graph to scroll to; null if it is visible. */
    var wanted: Int? by mutableStateOf(null)
        private set

    /** The ids of the graphs of which at least half is visible; null while none is shown at all. */
    var inSight: Set<Int>? = null

    /** The id of the graph that the pointer was last over; keys apply to that. */
    var pointed: Int? = null

    /** The graph that a key has just moved: until the pointer moves, keys go on with it, whatever is below the pointer now. */
    private var moved: Int? = null

    /** The graphs that a person arranged, without those that were put on top to show a finding. */
    val kept: Board get() = Board(state.graphs - added)

    /** The graph that keys apply to: the one just moved, the one last pointed at, or else the first visible one; null if there are none. */
    val current: BoardGraph?
        get() = state.graphs.find { it.id == moved } ?: state.graphs.find { it.id == pointed }
            ?: state.graphs.find { graph -> inSight?.let { graph.id in it } == true }
            ?: state.graphs.firstOrNull()

    /** Returns the title of [graph], which no other graph has. */
    fun titleOf(graph: BoardGraph): String = state.titleOf(graph)

    /** Changes the graphs by [transition]; [undo] restores the previous ones. */
    fun change(transition: Board.() -> Board) = take(history.changed(state.transition()))

    /** Goes to [changed], a step from [history]; the first new graph is scrolled to if it is out of sight. */
    fun take(changed: BoardHistory) {
        if (changed === history) return
        val before = state.graphs.associateBy { it.id }
        history = changed
        val seen = inSight ?: return
        // Nobody looks for graphs added outside the visible part, so scroll to the first of them. If all are new, that is the top.
        val added = state.graphs.filter { graph -> before[graph.id].let { it == null || it.lines.size < graph.lines.size } }
        if (added.size < state.graphs.size) added.firstOrNull()?.takeIf { it.id !in seen }?.let { goTo(it.id) }
    }

    /** Shows [board] instead, as for another log, without a history. */
    fun replace(board: Board) {
        added = emptySet()
        history = BoardHistory(board)
    }

    /** Shows [board] instead of the graphs that a person arranged, without a history; those that show a finding stay above it. */
    fun replaceKept(board: Board) {
        val first = (board.graphs.maxOfOrNull { it.id } ?: 0) + 1
        val shown = evidence.graphs.mapIndexed { i, graph -> graph.copy(id = first + i) }
        added = shown.toSet()
        history = BoardHistory(Board(shown + board.graphs))
    }

    /**
     * Shows [board] instead unless a person has changed something: graphs in it that are new are there to show a finding.
     */
    fun beginWith(board: Board) {
        if (canUndo) return
        val before = state.graphs.map { it.lines }
        history = BoardHistory(board)
        added = board.graphs.filterNot { it.lines in before }.toSet()
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

    /** Scrolls to graph [id], which a key has moved, if it is out of sight. */
    fun keepInSight(id: Int) {
        moved = id
        if (inSight?.contains(id) == false) goTo(id)
    }

    /**
     * Shows the graphs of [board] above all others, replacing those of the previous finding, except graphs that a person has changed
     * since.
     */
    fun showEvidence(board: Board) {
        if (!evidence.showsSame(board)) {
            val others = kept.graphs
            val first = (state.graphs.maxOfOrNull { it.id } ?: 0) + 1
            val graphs = board.graphs.mapIndexed { i, graph -> graph.copy(id = first + i) }
            added = added + graphs
            history = history.changed(Board(graphs + others))
        }
        evidence.graphs.firstOrNull()?.let { wanted = it.id }
    }

    /** Returns whether graph [id] is there only to show a finding. */
    fun isEvidence(id: Int): Boolean = evidence.graphs.any { it.id == id }

    /** Keeps graph [id], which shows a finding, or all of them for null: they then count as arranged by a person. */
    fun keep(id: Int? = null) {
        added = added - state.graphs.filter { id == null || it.id == id }.toSet()
    }

    /** Goes to graph [id]; null if it is visible. */
    fun goTo(id: Int?) {
        wanted = id
    }
}
