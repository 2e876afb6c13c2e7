package badlog.page.folder

import badlog.core.analysis.Graph
import badlog.page.board.addPin
import badlog.page.dom.Icon
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.element
import badlog.page.dom.isHidden
import badlog.page.dom.showText
import badlog.page.graph.GraphCard
import badlog.page.view.Scene
import badlog.page.view.SearchCounts
import badlog.viewer.choices.board.asBoardGraph
import badlog.viewer.shown.outline.LogOutline
import badlog.viewer.shown.outline.traits
import badlog.viewer.shown.search.Query
import badlog.viewer.shown.search.Trait
import badlog.viewer.text.countText
import org.w3c.dom.HTMLElement

/**
 * The topics of a large log that no graph shows. One list has the names and values of constant topics, another the names of topics without
 * samples. A list opens on request, or when it contains matches of a search.
 *
 * @param draw adds a graph to its folder.
 * @param onDraw called with each graph that was added.
 */
internal class FoldedTopics(outline: LogOutline, private val scene: Scene, draw: (Graph) -> GraphCard, onDraw: (GraphCard) -> Unit) {
    private val constants = FoldedList("Never change", "constants") {
        for (constant in outline.constants) {
            add(constant.name, "${constant.name} ${constant.text}", { constant.graph.series[0].traits }) {
                add("td").addButton("listed-graph", constant.name, "Draw ${constant.name}") { onDraw(draw(constant.graph)) }
                add("td", "constant-value", constant.text).title = constant.exact
                add("td").addPin(scene.board, constant.graph.asBoardGraph())
            }
        }
    }
    private val empty = FoldedList("Without samples", "empty-topics") {
        for (topic in outline.empty) add(topic.name, topic.name, { setOf(Trait.EMPTY) }) { add("td", "", topic.name) }
    }

    val element: HTMLElement = element("div", "folded") {
        for (list in listOf(constants, empty)) if (list.size > 0) appendChild(list.element)
    }

    /** Shows the rows that match [query]. */
    fun filter(query: Query): SearchCounts = SearchCounts(topics = constants.filter(query, scene) + empty.filter(query, scene))

    private class Row(val element: HTMLElement, val name: String, val haystack: String, makeTraits: () -> Set<Trait>) {
        val traits by lazy(makeTraits)
    }

    private class FoldedList(title: String, id: String, build: FoldedList.() -> Unit) {
        private val rows = ArrayList<Row>()
        private lateinit var count: HTMLElement
        private lateinit var body: HTMLElement
        private lateinit var toggle: HTMLElement
        private lateinit var table: HTMLElement
        private var isOpen = false
        val size: Int get() = rows.size

        val element: HTMLElement = element("section", "folder") {
            this.id = id
            add("h2", "folder-head") {
                toggle = addButton("folder-toggle", "") {
                    isOpen = !isOpen
                    show(isOpen)
                }.apply {
                    appendChild(Icon.CHEVRON.draw())
                    add("span", "folder-name", title)
                    count = add("span", "count")
                }
            }
            table = add("table", "folded-table card") {
                add("caption", "", title)
                body = add("tbody")
            }
        }

        init {
            build()
            count.showText(countText(size))
            show(false)
        }

        fun add(name: String, haystack: String, traits: () -> Set<Trait>, fill: HTMLElement.() -> Unit) {
            val row = body.add("tr") {
                setAttribute("data-name", name)
                fill()
            }
            rows += Row(row, name, haystack.lowercase(), traits)
        }

        fun filter(query: Query, scene: Scene): Int {
            val asksForTraits = Trait.entries.any(query::asksFor)
            var found = 0
            for (row in rows) {
                val traits = if (asksForTraits) row.traits + scene.findingsTraits(row.name) else emptySet()
                row.element.isHidden = !query.matchesLowercase(row.haystack, traits)
                if (!row.element.isHidden) found++
            }
            element.isHidden = found == 0
            count.showText(countText(found))
            show(isOpen || !query.isEmpty)
            return if (query.isEmpty) 0 else found
        }

        private fun show(isShown: Boolean) {
            toggle.setAttribute("aria-expanded", isShown.toString())
            table.isHidden = !isShown
        }
    }
}
