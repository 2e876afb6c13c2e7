package badlog.page.board

import badlog.page.dom.Icon
import badlog.page.dom.addIconButton
import badlog.page.dom.element
import badlog.page.dom.isHidden
import badlog.page.graph.GraphCard
import badlog.page.view.Scene
import badlog.page.view.graphsOf
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.BoardLines
import badlog.viewer.shown.search.Query
import badlog.viewer.state.GraphChange
import org.w3c.dom.HTMLElement

/**
 * A graph of the board: a card for its numbers and one for its states, if it has them.
 *
 * @param onMenu called with the button of its menu.
 */
internal class BoardItem(spec: BoardGraph, private val scene: Scene, private val onMenu: (BoardItem, HTMLElement) -> Unit) {
    private val lines: BoardLines = scene.board.lines

    /** The graph that it currently shows. */
    var spec: BoardGraph = spec
        private set

    private lateinit var menuButton: HTMLElement

    /** The cards that draw it. */
    val cards: List<GraphCard> = graphsOf(spec, lines).map { (graph, names) ->
        GraphCard(graph, scene, look = spec, lines = names) { look -> scene.store.send(GraphChange.Replace(look)) }
    }

    val element: HTMLElement = element("div", "board-graph") {
        setAttribute("data-id", spec.id.toString())
        for (card in cards) appendChild(card.element)
        cards.first().tools.apply {
            menuButton = addIconButton("graph-menu", Icon.MORE, "More for this graph") { openMenu() }
            menuButton.setAttribute("aria-haspopup", "menu")
            menuButton.setAttribute("aria-expanded", "false")
            addIconButton("pin", Icon.PIN, "Remove from the board (P)") { scene.store.send(GraphChange.Remove(spec.id)) }
                .setAttribute("aria-pressed", "true")
        }
    }

    /** Opens the menu of actions. */
    fun openMenu() = onMenu(this, menuButton)

    /** Returns whether it can show [other] without being recreated. */
    fun fits(other: BoardGraph): Boolean = lines === scene.board.lines &&
        withoutAdjustments(other) == withoutAdjustments(spec)

    /** Returns [graph] without the properties that can change while it is drawn. */
    private fun withoutAdjustments(graph: BoardGraph) =
        graph.copy(xRange = null, yRange = null, rightYRange = null, sharesY = false, hidden = emptySet())

    /** Shows the cards that match [query], and hides the others. */
    fun filter(query: Query) {
        for (card in cards) card.element.isHidden = !card.filter(query)
        element.isHidden = cards.all { it.element.isHidden }
    }

    /** Shows [wanted], for which [fits] is true. */
    fun show(wanted: BoardGraph) {
        if (wanted == spec) return
        spec = wanted
        for (card in cards) card.show(wanted)
    }
}
