package badlog.page.board

import badlog.page.graph.GraphCard
import badlog.page.graph.VisibleGraphs
import badlog.page.view.PageBoard
import badlog.viewer.state.GraphChange
import badlog.viewer.state.Request
import kotlinx.browser.document

/** Applies keys to the board, and to the graph that has the keyboard focus or is under the mouse. */
internal class BoardKeys(private val board: PageBoard, private val graphs: VisibleGraphs, private val section: BoardSection) {
    /** The graph of the board to which keys apply; null if there is none. */
    val current: Int? get() = graph()?.let { section.itemOf(it.element) }?.spec?.id

    /** Adds the graph to the board, or removes it. */
    fun togglePin() {
        val card = graph() ?: return
        val own = section.itemOf(card.element) ?: return card.pin()
        val next = section.after(own)
        board.send(GraphChange.Remove(own.spec.id))
        section.focus(next)
    }

    /** Remembers the board if it has changed. Scrolls to the graph that a key has moved if it is out of sight. */
    fun follow(change: Request.Graphs) {
        if (change.before != null) board.remember()
        change.moved?.let(section::keepInSight)
    }

    private fun graph(): GraphCard? {
        val active = document.activeElement
        val focused = active?.closest(".graph")
        val isByKeys = focused != null && active.matches(":focus-visible")
        return (if (isByKeys) focused else document.querySelector(".graph:hover") ?: focused)?.let(graphs::cardAt)
    }
}
