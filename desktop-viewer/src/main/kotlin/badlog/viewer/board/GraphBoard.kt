package badlog.viewer.board

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import badlog.plot.board.Board
import badlog.plot.board.BoardGraph
import badlog.plot.board.BoardHistory

/** The graphs that the window shows, from top to bottom, and what they were before. To be used on the window's thread only. */
internal class GraphBoard {
    private var history by mutableStateOf(BoardHistory())

    /** Each graph that showed a finding, as it came, less those that a person keeps: undoing brings back those of findings before, too. */
    private var added: Set<BoardGraph> by mutableStateOf(emptySet())

    /** The graphs. Whoever draws them is drawn again when they change. */
    val state: Board get() = history.now

    /** Whether there is something to undo. */
    val canUndo: Boolean get() = history.canUndo

    /** Whether something undone can be done again. */
    val canRedo: Boolean get() = history.canRedo

    /** The graphs that were put on top to show a finding, as far as a person left them as they were. */
    val evidence: Board get() = Board(state.graphs.filter { it in added })

    /** The graph that is to be scrolled to; null when a person sees it. */
    var wanted: Int? by mutableStateOf(null)
        private set

    /** The graphs of which a person sees at least the half, by their ids; null while none is shown at all. */
    var inSight: Set<Int>? = null

    /** The graph that the pointer was over last, by its id; keys are for that. */
    var pointed: Int? = null

    /** The graphs without those that were put on top to show a finding: what a person arranged. */
    val kept: Board get() = Board(state.graphs - added)

    /** The graph that keys are for: the one pointed at last, or else the first in sight; null without any. */
    val current: BoardGraph?
        get() = state.graphs.find { it.id == pointed } ?: state.graphs.find { graph -> inSight?.let { graph.id in it } == true }
            ?: state.graphs.firstOrNull()

    /** Shows what [transition] makes of the graphs; what was shown before comes back by [undo]. */
    fun change(transition: Board.() -> Board) {
        val before = state.graphs.associateBy { it.id }
        history = history.changed(state.transition())
        val seen = inSight ?: return
        // Nobody looks for what was added out of sight; of many, the first is the place to begin. Where all is new, that is the top.
        val added = state.graphs.filter { graph -> before[graph.id].let { it == null || it.lines.size < graph.lines.size } }
        if (added.size < state.graphs.size) added.firstOrNull()?.takeIf { it.id !in seen }?.let { goTo(it.id) }
    }

    /** Shows [board] instead, as of another log: there is nothing to undo. */
    fun replace(board: Board) {
        added = emptySet()
        history = BoardHistory(board)
    }

    /**
     * Shows [board] instead while a person has changed nothing: what it has besides the graphs of before is there to show a finding.
     */
    fun beginWith(board: Board) {
        if (canUndo) return
        val before = state.graphs.map { it.lines }
        history = BoardHistory(board)
        added = board.graphs.filterNot { it.lines in before }.toSet()
    }

    /** Shows what was shown before the last change. */
    fun undo() {
        history = history.undone()
    }

    /** Shows again what [undo] led away from. */
    fun redo() {
        history = history.redone()
    }

    /**
     * Shows the graphs of [board] above all others, in the place of those of the finding before. One of those that a person has changed
     * since stays.
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

    /** Whether graph [id] is there only to show a finding. */
    fun isEvidence(id: Int): Boolean = evidence.graphs.any { it.id == id }

    /** Keeps graph [id], which shows a finding, or all of them for null: they are a person's own from now on. */
    fun keep(id: Int? = null) {
        added = added - state.graphs.filter { id == null || it.id == id }.toSet()
    }

    /** Goes to graph [id]; null when it is in sight. */
    fun goTo(id: Int?) {
        wanted = id
    }
}
