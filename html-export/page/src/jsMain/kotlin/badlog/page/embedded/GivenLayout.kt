package badlog.page.embedded

import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardException
import badlog.viewer.choices.board.boardLayoutOf

/**
 * The layout that the page begins with.
 *
 * @property board its graphs; null for none.
 * @property formulas its formulas.
 * @property problem why it is not the intended layout, as a sentence; null if all is well.
 */
internal class GivenLayout private constructor(val board: Board?, val formulas: List<String>, val problem: String?) {
    companion object {
        /** Returns the layout in [text], a layout file; null for no layout. */
        fun of(text: String?): GivenLayout = try {
            val layout = text?.let { boardLayoutOf("The layout of this page", it) }
            GivenLayout(layout?.board, layout?.formulas.orEmpty(), null)
        } catch (e: BoardException) {
            GivenLayout(null, emptyList(), e.message)
        }
    }
}
