package badlog.page.board

import badlog.page.graph.GraphCard
import badlog.page.graph.VisibleGraphs
import badlog.page.view.PageBoard
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.GraphHeight
import badlog.viewer.input.Action
import kotlinx.browser.document

/** What keys do with the board, and with the graph that has the keyboard focus or is under the mouse. */
internal class BoardKeys(private val board: PageBoard, private val graphs: VisibleGraphs, private val section: BoardSection) {
    /** Performs [action] if it concerns the board. */
    fun perform(action: Action) {
        when (action) {
            Action.PIN -> graph()?.let(::pin)
            Action.MOVE_UP -> change { moved(it, -1) }
            Action.MOVE_DOWN -> change { moved(it, 1) }
            Action.NEXT_HEIGHT -> change { id -> resized(id, GraphHeight.of(graphs.find { it.id == id }?.height).next.pixels) }
            Action.UNDO -> board.undo()
            Action.REDO -> board.redo()
            else -> Unit
        }
    }

    private fun pin(card: GraphCard) {
        val own = section.itemOf(card.element) ?: return card.pin()
        val next = section.after(own)
        board.change { without(own.spec.id) }
        section.focus(next)
    }

    private fun change(step: Board.(Int) -> Board) {
        val id = graph()?.let { section.itemOf(it.element) }?.spec?.id ?: return
        board.change { step(id) }
    }

    private fun graph(): GraphCard? {
        val active = document.activeElement
        val focused = active?.closest(".graph")
        val isByKeys = focused != null && active.matches(":focus-visible")
        return (if (isByKeys) focused else document.querySelector(".graph:hover") ?: focused)?.let(graphs::cardAt)
    }
}
