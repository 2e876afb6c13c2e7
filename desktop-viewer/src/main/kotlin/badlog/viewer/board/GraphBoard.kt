package badlog.viewer.board

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import badlog.plot.board.Board
import badlog.plot.board.BoardGraph
import badlog.viewer.part.Part

/** The graphs that the window shows, from top to bottom. */
internal class GraphBoard : Part<Board>(Board()) {
    private var added: List<BoardGraph> by mutableStateOf(emptyList())

    /** The graphs that were put on top to show a finding, as far as a person left them as they were. */
    val evidence: Board get() = Board(state.graphs.filter { it in added })

    /** The graph that is to be scrolled to; null when a person sees it. */
    var wanted: Int? by mutableStateOf(null)
        private set

    /** The graphs of which a person sees at least the half, by their ids; null while none is shown at all. */
    var inSight: Set<Int>? = null

    /** The graphs without those that were put on top to show a finding: what a person arranged. */
    val kept: Board get() = Board(state.graphs - added.toSet())

    /** Shows [board] instead. */
    fun replace(board: Board) {
        added = emptyList()
        change { board }
    }

    /**
     * Shows the graphs of [board] above all others, in the place of those of the finding before. One of those that a person has changed
     * since stays.
     */
    fun showEvidence(board: Board) {
        if (!evidence.showsSame(board)) {
            val others = kept.graphs
            val first = (state.graphs.maxOfOrNull { it.id } ?: 0) + 1
            added = board.graphs.mapIndexed { i, graph -> graph.copy(id = first + i) }
            change { Board(added + others) }
        }
        added.firstOrNull()?.let { wanted = it.id }
    }

    /** Goes to graph [id]; null when it is in sight. */
    fun goTo(id: Int?) {
        wanted = id
    }
}
