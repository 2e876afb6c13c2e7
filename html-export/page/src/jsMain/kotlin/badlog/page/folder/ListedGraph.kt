package badlog.page.folder

import badlog.core.analysis.Graph
import badlog.page.board.addPin
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.element
import badlog.page.dom.isHidden
import badlog.page.graph.GraphCard
import badlog.page.view.Scene
import badlog.page.view.SearchedGraph
import badlog.viewer.choices.board.asBoardGraph
import badlog.viewer.shown.search.Query
import org.w3c.dom.HTMLElement

/**
 * A graph that is only listed until a person selects it or a search matches it.
 *
 * @param make creates its card.
 */
internal class ListedGraph(private val graph: Graph, private val scene: Scene, private val make: (Graph) -> GraphCard) {
    private val searched = SearchedGraph(graph, scene)
    private var isWanted = false
    private lateinit var row: HTMLElement

    /** Called with each card that is created or removed. */
    var onChange: (GraphCard) -> Unit = {}

    /** Its card; null while it is not drawn. */
    var card: GraphCard? = null
        private set

    val element: HTMLElement = element("div", "listed") {
        row = add("div", "listed-row") {
            addButton("listed-graph", "", "Draw ${graph.name}") {
                isWanted = true
                draw()
            }.apply {
                setAttribute("data-name", graph.name)
                add("span", "", graph.title)
                if (graph.series.size > 1) add("span", "count", "${graph.series.size} lines")
            }
            addPin(scene.board, graph.asBoardGraph())
        }
    }

    /** Returns whether [query] matches the graph, and no person has selected it. */
    fun isFoundBy(query: Query): Boolean = !isWanted && searched.isFoundBy(query)

    /** Shows the graph if [query] matches it, and draws it if [draws]. Returns whether it matches. */
    fun filter(query: Query, draws: Boolean): Boolean {
        val isFound = searched.isFoundBy(query)
        element.isHidden = !isFound
        if (isFound && draws && !query.isEmpty) {
            draw()
        } else if (!isWanted) {
            leave()
        }
        card?.filter(query)
        return isFound
    }

    private fun draw() {
        if (card != null) return
        row.isHidden = true
        val made = make(graph)
        card = made
        element.appendChild(made.element)
        onChange(made)
    }

    private fun leave() {
        val gone = card ?: return
        card = null
        onChange(gone)
        gone.element.remove()
        row.isHidden = false
    }
}
