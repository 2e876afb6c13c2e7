package badlog.page.embedded

import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardException
import badlog.viewer.choices.board.boardLayoutOf

/**
 * The layout with which the page begins.
 *
 * @property board its graphs; null if there are none.
 * @property formulas its formulas.
 * @property problem the reason why the layout cannot be used, as a sentence; null if it can.
 */
internal class GivenLayout private constructor(val board: Board?, val formulas: List<String>, val problem: String?) {
    companion object {
        /** Returns the layout in [text], a layout file; null means no layout. */
        fun of(text: String?): GivenLayout = try {
            val layout = text?.let { boardLayoutOf("The layout of this page", it) }
            GivenLayout(layout?.board, layout?.formulas.orEmpty(), null)
        } catch (e: BoardException) {
            GivenLayout(null, emptyList(), e.message)
        }
    }
}
