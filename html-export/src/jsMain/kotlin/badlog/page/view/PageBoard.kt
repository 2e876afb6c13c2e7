package badlog.page.view

import badlog.page.dom.LocalStorage
import badlog.plot.board.Board
import badlog.plot.board.BoardException
import badlog.plot.board.BoardHistory
import badlog.plot.board.BoardLines
import badlog.plot.board.boardOfJson
import badlog.plot.board.fittedTo
import badlog.plot.board.toJson

/**
 * The graphs that the reader put together, which the browser remembers for the file.
 *
 * @param lines all that may be drawn.
 */
internal class PageBoard(fileKey: String, lines: BoardLines) {
    private val key = "board:$fileKey"
    private var history = BoardHistory()
    private val listeners = ArrayList<() -> Unit>()

    /** What it began with, unless the browser remembered one. */
    private var begun: BoardHistory? = null

    /** Is called when the reader has changed it. */
    var onKeep: () -> Unit = {}

    /** All that may be drawn; others when formulas have changed. */
    var lines: BoardLines = lines
        set(value) {
            field = value
            show(history)
        }

    /** What is shown: the board as far as there are lines for it. */
    var now: Board = Board()
        private set

    val canUndo: Boolean get() = history.canUndo
    val canRedo: Boolean get() = history.canRedo

    /** Calls [listener] after each change. */
    fun onChange(listener: () -> Unit) {
        listeners += listener
    }

    /** Begins with [visited], which somebody has sent; without it, and when that is undone, with what the browser remembers, else [board]. */
    fun begin(visited: Board?, board: () -> Board) {
        val own = remembered()
        val first = BoardHistory(own ?: board())
        if (own == null) begun = first
        show(if (visited == null) first else first.changed(visited))
    }

    /** Begins with [board] instead, unless the reader has another one already. */
    fun beginAgain(board: Board) {
        if (history !== begun || board.showsSame(history.now)) return
        begun = BoardHistory(board).also(::show)
    }

    /** Does [step], which can be undone, and remembers what comes of it. */
    fun change(step: Board.() -> Board) = keep(history.changed(now.step()))

    /** Shows [board], which somebody else has sent: the reader's own comes back by undoing, and is remembered until something is changed. */
    fun visit(board: Board) = show(history.changed(board))

    fun undo() = keep(history.undone())

    fun redo() = keep(history.redone())

    private fun keep(changed: BoardHistory) {
        if (changed === history) return
        show(changed)
        LocalStorage[key] = history.now.toJson()
        onKeep()
    }

    private fun show(changed: BoardHistory) {
        history = changed
        now = changed.now.fittedTo { lines[it] != null }.board
        for (listener in listeners) listener()
    }

    private fun remembered(): Board? = try {
        LocalStorage[key]?.let(::boardOfJson)
    } catch (_: BoardException) {
        null
    }

    internal companion object {
        /** So many graphs are offered to be added to: more would not fit the screen. */
        const val MOST_OFFERED = 12
    }
}
