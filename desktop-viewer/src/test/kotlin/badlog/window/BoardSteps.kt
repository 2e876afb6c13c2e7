package badlog.window

import badlog.viewer.choices.board.Board
import badlog.viewer.state.BoardAction
import badlog.window.log.GraphBoard

/** Changes the drawn graphs by [step], as a person does. */
internal fun GraphBoard.change(step: Board.() -> Board) = send(BoardAction.Show(state.step()))

/** The graphs that a person arranged, without those that show a finding. */
internal val GraphBoard.kept: Board get() = Board(state.graphs - evidence.graphs.toSet())
