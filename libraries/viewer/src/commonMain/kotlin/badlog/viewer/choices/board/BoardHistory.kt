package badlog.viewer.choices.board

/**
 * A board with its undo and redo history. Immutable; each step returns a new one.
 *
 * @param at the index in [steps] of the current board; later ones were undone.
 * @param newId returns an id that no graph of any tab or window has; null if no other tab or window changes this board.
 */
class BoardHistory private constructor(private val steps: List<Board>, private val at: Int, private val newId: (() -> Int)?) {
    /** Creates a history that begins with [board]. */
    constructor(board: Board = Board(), newId: (() -> Int)? = null) : this(listOf(board), 0, newId)

    /** The current board. */
    val now: Board get() = steps[at]

    /** Whether a change can be undone. */
    val canUndo: Boolean get() = at > 0

    /** Whether an undone change can be redone. */
    val canRedo: Boolean get() = at < steps.lastIndex

    /**
     * Shows [board], a changed copy of [shown], the part of [now] that the open log can show. The rest of [now] stays. Returns this history
     * if [board] shows the same.
     */
    internal fun changed(board: Board, shown: Board = now): BoardHistory {
        val own = identified(board)
        val whole = if (shown === now) own else own.mergedWith(now, shown)
        if (whole.showsSame(now)) return this
        val all = (steps.take(at + 1) + whole).takeLast(MAX_STEPS + 1)
        return BoardHistory(all, all.lastIndex, newId)
    }

    /** Returns a history that begins with [board]. */
    internal fun begunWith(board: Board): BoardHistory = BoardHistory(board, newId)

    /** Undoes the last change. */
    internal fun undone(): BoardHistory = if (canUndo) BoardHistory(steps, at - 1, newId) else this

    /** Redoes the change that [undone] undid. */
    internal fun redone(): BoardHistory = if (canRedo) BoardHistory(steps, at + 1, newId) else this

    /** Returns this history with [change] applied to each board, so that it cannot be undone. */
    internal fun everywhere(change: Board.() -> Board): BoardHistory = withSteps(steps.map(change))

    /** Returns a history of the [changed] steps of this one, without steps that show the same as the step before. */
    private fun withSteps(changed: List<Board>): BoardHistory {
        val all = ArrayList<Board>()
        var place = 0
        for ((i, step) in changed.withIndex()) {
            val before = all.lastOrNull()
            if (before == null || !step.showsSame(before)) {
                all += step
            } else if (i == at) {
                all[all.lastIndex] = step
            }
            if (i == at) place = all.lastIndex
        }
        return BoardHistory(all, place, newId)
    }

    /** Returns [board] with new ids for graphs that were never in this history. A board knows only which ids are free on it. */
    private fun identified(board: Board): Board {
        val id = newId ?: return board
        return Board(
            board.graphs.map { graph ->
                val wasHere = steps.any { step -> step.graphs.any { it.id == graph.id && it.isOnceSame(graph) } }
                if (wasHere || graph.id == graph.idOfLines) graph else graph.copy(id = id())
            },
        )
    }

    private fun BoardGraph.isOnceSame(other: BoardGraph) = title == other.title || lines.any { it in other.lines }
}

private const val MAX_STEPS = 100
