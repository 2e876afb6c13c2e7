package badlog.viewer.state

import badlog.viewer.choices.board.BoardHistory

/** What changes the graphs that a person put together, besides keys. */
sealed interface BoardAction : Action {
    /** Goes to [board], a step from the one that is shown: a person has changed it. */
    class Take(val board: BoardHistory) : BoardAction

    /** Shows [board], which the log begins with, or others have changed. */
    class Show(val board: BoardHistory) : BoardAction
}
