package badlog.viewer.state

import badlog.viewer.choices.board.Board
import badlog.viewer.choices.note.Note as LogNote

/**
 * A task that only a shell can perform. The shells' `when` has no `else`, so that a new task does not compile until page and window both
 * perform it.
 */
sealed interface Request {
    /** Opens the values at the cursor, or closes them. */
    object Values : Request

    /** Opens the modules of a swerve drive at the cursor, or closes them. For a log without modules, says so. */
    object Modules : Request

    /** Adds the graph that keys apply to, or removes it: it need not be one of the board's. */
    object Pin : Request

    /**
     * Remembers the board, and shows which graphs are new if they are out of sight.
     *
     * @property before the graphs that were drawn before the change; null if nothing has changed.
     * @property moved the graph that a key has moved, which is shown, too; null for none.
     */
    data class Graphs(val before: Board?, val moved: Int? = null) : Request

    /** Shows the graphs of the kept layout that is [steps] after the one shown, see [keptLayoutAfter][badlog.viewer.choices.board.keptLayoutAfter]. */
    class Layout(val steps: Int) : Request

    /** Announces the place to which the keys have moved a cursor. */
    object Cursor : Request

    /** Asks for a formula. */
    object Formula : Request

    /** Asks for the text of a note at [x]. */
    data class Note(val x: Double) : Request

    /** Asks for a new text for [note]. */
    class ChangeNote(val note: LogNote) : Request

    /** Removes [note], and offers to restore it. */
    class RemoveNote(val note: LogNote) : Request

    /** Adds a mark at [x], a note that needs no text. */
    data class Mark(val x: Double) : Request

    /** Shows the frame of the video that is [count] further, or back if negative, and moves the cursor there. */
    class Frames(val count: Int) : Request
}
