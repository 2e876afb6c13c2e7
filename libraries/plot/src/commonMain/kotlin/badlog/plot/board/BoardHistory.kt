package badlog.plot.board

/**
 * A board, what it was before, and what undoing led away from. Never changes; each step gives a new one.
 *
 * @property now the board that is shown.
 */
public class BoardHistory private constructor(public val now: Board, private val before: List<Board>, private val after: List<Board>) {
    /** One that begins with [board]. */
    public constructor(board: Board = Board()) : this(board, emptyList(), emptyList())

    /** Whether there is something to undo. */
    public val canUndo: Boolean get() = before.isNotEmpty()

    /** Whether something undone can be done again. */
    public val canRedo: Boolean get() = after.isNotEmpty()

    /** Shows [board]; nothing changes where that shows the same. */
    public fun changed(board: Board): BoardHistory =
        if (board.showsSame(now)) this else BoardHistory(board, (before + now).takeLast(MAX_STEPS), emptyList())

    /** Shows what was shown before. */
    public fun undone(): BoardHistory = if (canUndo) BoardHistory(before.last(), before.dropLast(1), after + now) else this

    /** Shows again what [undone] led away from. */
    public fun redone(): BoardHistory = if (canRedo) BoardHistory(after.last(), before + now, after.dropLast(1)) else this

    private companion object {
        const val MAX_STEPS = 100
    }
}
