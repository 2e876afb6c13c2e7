package badlog.viewer.session

import badlog.core.analysis.EnabledSpan
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardHistory
import badlog.viewer.shown.cursor.CursorSteps
import badlog.viewer.shown.finding.FindingOrder
import badlog.viewer.shown.finding.FindingStep

/**
 * What keys change of a log that is shown.
 *
 * @property place where the person is in it.
 * @property board the graphs that the person put together.
 * @property graphs those of them that can be drawn of this log.
 * @property graph the graph of these that keys apply to; null for none.
 */
class Session(val place: Place, val board: BoardHistory, val graphs: Board = board.now, val graph: Int? = null) {
    internal fun at(place: Place) = Session(place, board, graphs, graph)

    internal fun changed(to: Board) = Session(place, board.changed(to, graphs), to, graph)

    internal fun with(board: BoardHistory) = Session(place, board, graphs, graph)
}

/** What keys need of a log: each is asked for by the first key that needs it. */
interface Shown {
    /** The samples that a cursor steps to. */
    val samples: CursorSteps

    /** When the robot was enabled. */
    val enabled: List<EnabledSpan>

    /** The order in which keys go through the findings; null until the rules have run. */
    val findings: FindingOrder?

    /** The newest moment of a log that is being written; null for any other. */
    val newest: Double? get() = null
}

/**
 * What only a front end can do for a key. Its `when` over these has no `else`, so that a new one does not compile until page and window
 * both do it.
 */
sealed interface Request {
    /** Opens the values at the cursor, or closes them. */
    data object Values : Request

    /** Opens the modules of a swerve drive at the cursor, or closes them; for a log without any, it says so. */
    data object Modules : Request

    /** Adds the graph that keys apply to, or removes it: it need not be one of the board's. */
    data object Pin : Request

    /** Shows graph [id] of the board, which was moved, if it is out of sight. */
    data class Graph(val id: Int) : Request

    /** Shows the graphs of the kept layout that is [steps] after the one shown, see [keptLayoutAfter][badlog.viewer.choices.board.keptLayoutAfter]. */
    data class Layout(val steps: Int) : Request

    /** Tells where the keys have moved a cursor. */
    data object Cursor : Request

    /** Shows the finding that [step] leads to: what was found, and its evidence. */
    data class Finding(val step: FindingStep) : Request

    /** Says that there is no finding to go to, or that the rules are still running. */
    data object NoFinding : Request

    /** Asks for a formula. */
    data object Formula : Request

    /** Asks for the text of a note at [x]. */
    data class Note(val x: Double) : Request

    /** Adds a mark at [x], a note that needs no text. */
    data class Mark(val x: Double) : Request

    /** Shows the picture of the video that is [count] further on, or back if negative, and moves the cursor there. */
    data class Frames(val count: Int) : Request
}

/**
 * What a key leads to.
 *
 * @property session what is shown from now on.
 * @property request what the front end has to do besides; null for nothing.
 */
class Outcome(val session: Session, val request: Request? = null)
