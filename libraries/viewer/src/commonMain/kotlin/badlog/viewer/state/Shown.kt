package badlog.viewer.state

import badlog.core.analysis.EnabledSpan
import badlog.viewer.choices.board.Board
import badlog.viewer.shown.cursor.CursorSteps
import badlog.viewer.shown.finding.RuleResults

/** The content of an open log that [reduce] needs besides the state. Each part is calculated for the first action that needs it. */
interface Shown {
    /** Whether a log is open. */
    val isOpen: Boolean get() = true

    /** The samples that a cursor steps to. */
    val samples: CursorSteps

    /** The time when the robot was enabled. */
    val enabled: List<EnabledSpan>

    /** The findings; null while none are known. */
    val found: RuleResults?

    /** The graphs of the board that can be drawn for the log. */
    val graphs: Board

    /** The id of the graph, one of [graphs], to which keys apply; null for none. */
    val graph: Int? get() = null

    /** The newest moment of a log that is being written; null for any other. */
    val newest: Double? get() = null
}
