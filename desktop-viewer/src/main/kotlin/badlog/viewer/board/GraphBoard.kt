package badlog.viewer.board

import badlog.plot.board.Board
import badlog.viewer.part.Part

/** The graphs that the window shows, from top to bottom. */
internal class GraphBoard : Part<Board>(Board()) {
    /** Shows [board] instead. */
    fun replace(board: Board) = change { board }
}
