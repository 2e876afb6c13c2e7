package badlog.viewer.choices.board

import badlog.viewer.choices.mergedWith

/**
 * A board with its undo and redo history. Immutable; each step returns a new one.
 *
 * @property now the board that is shown.
 */
class BoardHistory private constructor(val now: Board, private val before: List<Board>, private val after: List<Board>) {
    /** Creates a history that begins with [board]. */
    constructor(board: Board = Board()) : this(board, emptyList(), emptyList())

    /** Whether there is something to undo. */
    val canUndo: Boolean get() = before.isNotEmpty()

    /** Whether something undone can be done again. */
    val canRedo: Boolean get() = after.isNotEmpty()

    /** Shows [board]; nothing changes if that shows the same. */
    fun changed(board: Board): BoardHistory =
        if (board.showsSame(now)) this else BoardHistory(board, (before + now).takeLast(MAX_STEPS), emptyList())

    /** Undoes the last change. */
    fun undone(): BoardHistory = if (canUndo) BoardHistory(before.last(), before.dropLast(1), after + now) else this

    /** Redoes what [undone] undid. */
    fun redone(): BoardHistory = if (canRedo) BoardHistory(after.last(), before + now, after.dropLast(1)) else this

    /**
     * Returns this history with what other tabs or windows have changed of the board that they remember in one place, see
     * [mergedWith][badlog.viewer.choices.mergedWith]: in each of its boards, so that undoing does not undo what others did.
     */
    fun mergedWith(stored: Board, read: Board): BoardHistory = if (stored.showsSame(read)) {
        this
    } else {
        BoardHistory(now.mergedWith(stored, read), before.map { it.mergedWith(stored, read) }, after.map { it.mergedWith(stored, read) })
    }

    private fun Board.mergedWith(stored: Board, read: Board): Board {
        val merged = graphs.mergedWith(stored.graphs, read.graphs) { it.copy(id = 0) }
        val (own, others) = merged.partition { graph -> graphs.any { it === graph } }
        return Board(own).withGraphs(others)
    }

    private companion object {
        const val MAX_STEPS = 100
    }
}
