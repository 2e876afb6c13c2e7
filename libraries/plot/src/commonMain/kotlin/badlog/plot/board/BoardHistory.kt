package badlog.plot.board

/**
 * A board with its undo and redo history. Immutable; each step returns a new one.
 *
 * @property now the board that is shown.
 */
public class BoardHistory private constructor(public val now: Board, private val before: List<Board>, private val after: List<Board>) {
    /** Creates a history that begins with [board]. */
    public constructor(board: Board = Board()) : this(board, emptyList(), emptyList())

    /** Whether there is something to undo. */
    public val canUndo: Boolean get() = before.isNotEmpty()

    /** Whether something undone can be done again. */
    public val canRedo: Boolean get() = after.isNotEmpty()

    /** Shows [board]; nothing changes if that shows the same. */
    public fun changed(board: Board): BoardHistory =
        if (board.showsSame(now)) this else BoardHistory(board, (before + now).takeLast(MAX_STEPS), emptyList())

    /** Undoes the last change. */
    public fun undone(): BoardHistory = if (canUndo) BoardHistory(before.last(), before.dropLast(1), after + now) else this

    /** Redoes what [undone] undid. */
    public fun redone(): BoardHistory = if (canRedo) BoardHistory(after.last(), before + now, after.dropLast(1)) else this

    private companion object {
        const val MAX_STEPS = 100
    }
}
