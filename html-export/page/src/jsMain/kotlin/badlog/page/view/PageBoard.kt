package badlog.page.view

import badlog.page.dom.LocalStorage
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardException
import badlog.viewer.choices.board.BoardHistory
import badlog.viewer.choices.board.BoardLines
import badlog.viewer.choices.board.boardOfJson
import badlog.viewer.choices.board.fittedTo
import badlog.viewer.choices.board.mergedWith
import badlog.viewer.choices.board.toJson
import badlog.viewer.input.KeyAction
import badlog.viewer.state.Action
import badlog.viewer.state.BoardAction

/**
 * The graphs that the reader put together, which the browser remembers for the file.
 *
 * @param lines all lines that can be drawn.
 */
internal class PageBoard(fileKey: String, lines: BoardLines, private val store: PageStore) {
    private val key = "board:$fileKey"
    private val listeners = ArrayList<() -> Unit>()

    /** The board, and the changes that can be undone. */
    private val history: BoardHistory get() = store.state.board

    /** The board it began with, unless the browser remembered one. */
    private var begun: Board? = null

    /** The board of this tab as it was last read or stored; while nothing is stored, the one it began with. */
    private var known = Board()

    /** Returns the board that the page begins with for everybody. */
    private var start: () -> Board = { Board() }

    /** Called when the reader has changed the board. */
    var onKeep: () -> Unit = {}

    /** All lines that can be drawn; they change with the formulas. */
    var lines: BoardLines = lines
        set(value) {
            field = value
            show()
        }

    /** The displayed board: the part for which there are lines. */
    var now: Board = Board()
        private set

    /** Whether the board is the one with which the page begins for every reader. */
    val isUntouched: Boolean get() = begun?.fittedTo { lines[it] != null }?.board?.showsSame(now) == true

    val canUndo: Boolean get() = history.canUndo
    val canRedo: Boolean get() = history.canRedo

    init {
        store.onChange { before ->
            val isSame = before.board.now == history.now && before.board.canUndo == canUndo && before.board.canRedo == canRedo
            if (!isSame) show()
        }
    }

    /** Calls [listener] after each change. */
    fun onChange(listener: () -> Unit) {
        listeners += listener
    }

    /**
     * Begins with [visited], the board of a link. If it is null or undone, the board is the one that the browser remembers, otherwise
     * [board].
     */
    fun begin(visited: Board?, board: () -> Board) {
        val own = remembered()
        start = board
        known = own ?: board()
        if (own == null) begun = known
        send(BoardAction.Begin(known, visited))
    }

    /** Begins with [board] instead, unless the reader already has another one. */
    fun beginAgain(board: Board) {
        start = { board }
        // A formula that was added and removed again leaves no step, though the board was remembered.
        if (begun == null || canUndo || canRedo || remembered() != null || board.showsSame(history.now)) return
        known = board
        begun = board
        send(BoardAction.Begin(board))
    }

    /** Shows the board with which the page begins for every reader; this can be undone. */
    fun startAgain() = send(BoardAction.Show(start()))

    /** Applies [action] to the graphs. */
    fun send(action: BoardAction) = store.send(action)

    /** Shows [board], the board of a link. Undoing restores the reader's own, which is remembered until something is changed. */
    fun visit(board: Board) = send(BoardAction.Visit(board))

    /** Undoes the reader's last change of the board; does nothing if there is none. */
    fun undo() = store.send(Action.Press(KeyAction.UNDO))

    /** Repeats the change that was undone last; does nothing if there is none. */
    fun redo() = store.send(Action.Press(KeyAction.REDO))

    /** Stores the changes of the board. Graphs that other tabs changed meanwhile stay as they stored them; this tab does not show them. */
    fun remember() {
        val text = history.now.mergedWith(remembered() ?: known, known).toJson(haveIds = true)
        LocalStorage[key] = text
        // Without room in the storage, the change is stored with the next one.
        if (LocalStorage[key] == text) known = history.now
        onKeep()
    }

    private fun show() {
        now = history.now.fittedTo { lines[it] != null }.board
        for (listener in listeners) listener()
    }

    private fun remembered(): Board? = try {
        LocalStorage[key]?.let(::boardOfJson)
    } catch (_: BoardException) {
        null
    }

    internal companion object {
        /** The maximum number of graphs offered as targets: more would not fit on the screen. */
        const val MAX_OFFERED = 12
    }
}
