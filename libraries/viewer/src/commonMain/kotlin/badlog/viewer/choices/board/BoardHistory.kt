package badlog.viewer.choices.board

/**
 * A board with its undo and redo history. Immutable; each step returns a new one.
 *
 * @property now the board that is shown.
 * @param newId returns an id that no graph of any tab or window has; null if nobody else changes this board.
 */
class BoardHistory private constructor(
    val now: Board,
    private val before: List<Board>,
    private val after: List<Board>,
    private val newId: (() -> Int)?,
) {
    /** Creates a history that begins with [board]. */
    constructor(board: Board = Board(), newId: (() -> Int)? = null) : this(board, emptyList(), emptyList(), newId)

    /** Whether there is something to undo. */
    val canUndo: Boolean get() = before.isNotEmpty()

    /** Whether something undone can be done again. */
    val canRedo: Boolean get() = after.isNotEmpty()

    /**
     * Shows [board], a change of [shown], which is the part of [now] that the open log can show: the rest stays. Nothing changes if it shows
     * the same.
     */
    fun changed(board: Board, shown: Board = now): BoardHistory {
        val own = identified(board)
        val whole = if (shown === now) own else own.mergedWith(now, shown)
        return if (whole.showsSame(now)) this else BoardHistory(whole, (before + now).takeLast(MAX_STEPS), emptyList(), newId)
    }

    /** Undoes the last change. */
    fun undone(): BoardHistory = if (canUndo) BoardHistory(before.last(), before.dropLast(1), after + now, newId) else this

    /** Redoes what [undone] undid. */
    fun redone(): BoardHistory = if (canRedo) BoardHistory(after.last(), before + now, after.dropLast(1), newId) else this

    /**
     * Returns this history with what other tabs or windows have changed of the board that they remember in one place, since this one
     * [read] it: in each of its boards, so that undoing does not undo what others did.
     */
    fun mergedWith(stored: Board, read: Board): BoardHistory {
        if (stored.showsSame(read)) return this
        // After undoing, others have the last word.
        val merged = now.mergedWith(stored, read, prefersStored = canRedo)

        fun steps(boards: List<Board>): List<Board> {
            val all = boards.map { it.mergedWith(stored, read, prefersStored = true) } + merged
            return all.filterIndexed { i, board -> i < boards.size && !board.showsSame(all[i + 1]) }
        }
        return BoardHistory(merged, steps(before), steps(after), newId)
    }

    /** Returns [board] with ids of their own for graphs that were never in this history: a board knows only which ids are free on it. */
    private fun identified(board: Board): Board {
        val id = newId ?: return board
        val known = before + after + now
        return Board(
            board.graphs.map { graph ->
                val isKnown = known.any { it.graphs.any { other -> other.id == graph.id && other.isOnceSame(graph) } }
                if (isKnown) graph else graph.copy(id = id())
            },
        )
    }

    private fun BoardGraph.isOnceSame(other: BoardGraph) = title == other.title || lines.any { it in other.lines }

    private companion object {
        const val MAX_STEPS = 100
    }
}
