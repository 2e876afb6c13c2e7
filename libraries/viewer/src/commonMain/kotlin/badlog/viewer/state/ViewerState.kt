package badlog.viewer.state

import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardHistory

/**
 * The state of an open log: what a person has put together, where the person is, and which parts of panels are open. Immutable: [reduce]
 * returns the next one.
 *
 * @property place where the person is in the log.
 * @property board the graphs that the person put together, with what can be undone.
 * @property findings what is searched and unfolded in the findings.
 */
data class ViewerState(val place: Place, val board: BoardHistory, val findings: FindingsState = FindingsState()) {
    internal fun at(place: Place) = copy(place = place)

    /** Returns the state with the graphs [to] in place of [shown], the drawn part of the board. */
    internal fun changed(shown: Board, to: Board) = copy(board = board.changed(to, shown))
}
