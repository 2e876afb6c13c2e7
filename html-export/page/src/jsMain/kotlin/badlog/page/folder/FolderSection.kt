package badlog.page.folder

import badlog.core.analysis.EventLog
import badlog.core.analysis.Folder
import badlog.core.analysis.Graph
import badlog.core.recording.Value
import badlog.page.board.addPin
import badlog.page.dom.Icon
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.bringIntoSight
import badlog.page.dom.element
import badlog.page.dom.focusInPlace
import badlog.page.dom.isHidden
import badlog.page.dom.showText
import badlog.page.graph.GraphCard
import badlog.page.parts.PartNodes
import badlog.page.parts.patch
import badlog.page.view.Scene
import badlog.page.view.SearchCounts
import badlog.page.view.SearchedGraph
import badlog.protocol.HookPart
import badlog.viewer.choices.board.asBoardGraph
import badlog.viewer.choices.board.framesOf
import badlog.viewer.choices.board.laneGraphOf
import badlog.viewer.draw.mark.EventTimeline
import badlog.viewer.panel.eventRows
import badlog.viewer.panel.valueRows
import badlog.viewer.shown.search.Query
import badlog.viewer.text.countOf
import badlog.viewer.text.countText
import org.w3c.dom.HTMLElement

/**
 * A folder with its values, event logs and graphs. All folders except the root can be closed.
 *
 * @param origin returns the origin of a graph that was calculated; empty for a logged one.
 * @param listed the graphs that are drawn only on request; [onDraw] is then called with each, [onLeave] with each that is removed.
 * @param hook the program that made the folder's content; null for a folder of the recording.
 * @param isClosed whether it is initially closed.
 * @param onToggle called when a person opens or closes it.
 */
internal class FolderSection(
    val folder: Folder,
    scene: Scene,
    isClosed: Boolean,
    private val onToggle: () -> Unit,
    private val origin: (Graph) -> String = { "" },
    private val hook: HookPart? = null,
    listed: List<Graph> = emptyList(),
    private val onDraw: (GraphCard) -> Unit = {},
    private val onLeave: (GraphCard) -> Unit = {},
) {
    private val values = folder.values.takeIf { it.isNotEmpty() }?.let { ValueList(it, scene) }
    private var toggle: HTMLElement? = null
    private var countLabel: HTMLElement? = null
    private lateinit var body: HTMLElement
    private val drawn = framesOf(folder.graphs) { origin(it).isNotEmpty() }.map(::laneGraphOf)
        .mapTo(ArrayList()) { GraphCard(it, scene, origin(it)) }
    private val undrawn = listed.map { ListedGraph(it, scene) { graph -> GraphCard(graph, scene, origin(graph)) } }
    private var isSearching = false

    /** The event logs, in their order. */
    val tables: List<EventTable> = folder.eventLogs.map { EventTable(it, scene) }

    /** The graphs, in their order. */
    val cards: List<GraphCard> get() = drawn + undrawn.mapNotNull { it.card }

    /** The heading. */
    val caption: String =
        if (hook == null) folder.name.split('/').joinToString(" / ").ifEmpty { "Top level" } else folder.name

    /** A shorter heading for narrow places. */
    val shortCaption: String get() = if (hook == null) caption else "Hook ${hook.name}"

    /** The names of its parent folders, then its own. */
    val path: List<String> get() = if (hook == null && folder.name.isNotEmpty()) folder.name.split('/') else listOf(shortCaption)

    private val size get() = cards.size + undrawn.count { it.card == null } + tables.size + (hook?.figures?.size ?: 0)

    /** The number of items in it; during a search, the number of matches. */
    var count: Int = size
        private set(value) {
            field = value
            countLabel?.showText(countText(value))
        }

    /** Whether a person closed it; always false for the root folder. */
    var isClosed: Boolean = isClosed && folder.name.isNotEmpty()
        set(value) {
            field = value && folder.name.isNotEmpty()
            showOpenness()
        }

    val element: HTMLElement = element("section", "folder") {
        setAttribute("data-name", folder.name)
        if (hook != null) classList.add("hook")
        if (folder.name.isEmpty()) setAttribute("aria-label", "Top level") else addHeading()
        body = add("div", "folder-body") {
            if (hook != null) add("p", "hook-note", "Calculated by a program, not logged by the robot.")
            values?.let { appendChild(it.element) }
            for (table in tables) appendChild(table.element)
            for (card in drawn) appendChild(card.element)
            for (graph in undrawn) appendChild(graph.element)
            if (hook != null) for (figure in hook.figures) appendChild(hookPicture(figure))
        }
    }

    init {
        for (graph in undrawn) graph.onChange = { card -> if (graph.card === card) onDraw(card) else onLeave(card) }
        showOpenness()
    }

    /** Returns the number of undrawn graphs that match [query]. */
    fun countListed(query: Query): Int = undrawn.count { it.isFoundBy(query) }

    /**
     * Shows the items that match [query], and opens the folder during a search. With [drawsListed], also draws listed graphs that match.
     */
    fun filter(query: Query, drawsListed: Boolean): SearchCounts {
        isSearching = !query.isEmpty
        var graphs = 0
        for (card in drawn) {
            card.element.isHidden = !card.filter(query)
            if (!card.element.isHidden) graphs++
        }
        graphs += undrawn.count { it.filter(query, drawsListed) }
        val hits = SearchCounts(graphs, values?.filter(query) ?: 0, tables.sumOf { it.filter(query) })
        count = if (isSearching) hits.sum else size
        element.isHidden = isSearching && hits.isEmpty
        showOpenness()
        return hits
    }

    /** Opens the folder and scrolls to [part] of it. */
    fun reveal(part: HTMLElement = element) {
        if (isClosed) {
            isClosed = false
            onToggle()
        }
        part.bringIntoSight()
    }

    /** Adds [card] below the others. */
    fun add(card: GraphCard) {
        drawn += card
        body.appendChild(card.element)
        count = size
    }

    /** Removes [card] from the section and from the page. */
    fun remove(card: GraphCard) {
        drawn -= card
        card.element.remove()
        count = size
    }

    private fun HTMLElement.addHeading() {
        add("h2", "folder-head") {
            toggle = addButton("folder-toggle", "") {
                isClosed = !isClosed
                onToggle()
            }.apply {
                appendChild(Icon.CHEVRON.draw())
                add("span", "folder-name", caption)
                countLabel = add("span", "count", countText(count))
            }
        }
    }

    private fun showOpenness() {
        val isOpen = !isClosed || isSearching
        toggle?.setAttribute("aria-expanded", isOpen.toString())
        body.isHidden = !isOpen
    }
}

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

/** The events of a topic, see [eventRows]. */
internal class EventTable(private val log: EventLog, private val scene: Scene) {
    private val all = EventTimeline.of(listOf(log))
    private var found = all
    private var limit = PAGE
    private val nodes = PartNodes(scene.palette) { if (scene.xAxis.range != null) scene.store.send(it) }
    private lateinit var count: HTMLElement
    private lateinit var scroll: HTMLElement
    private lateinit var body: HTMLElement
    private lateinit var more: HTMLElement

    val element: HTMLElement = element("section", "events card") {
        setAttribute("data-name", log.name)
        add("header", "graph-head") {
            add("h3", "graph-title", log.title).title = log.name
            count = add("span", "unit")
        }
        if (all.size == 0) add("p", "unit", "No events.")
        scroll = add("div", "events-scroll") {
            isHidden = all.size == 0
            setAttribute("tabindex", "0")
            setAttribute("role", "group")
            setAttribute("aria-label", "Events of ${log.name}")
            body = add("div")
            more = addButton("more text-button", "") {
                limit += PAGE
                show()
            }
        }
    }

    init {
        show()
    }

    /** The number of listed events. */
    val foundCount: Int get() = found.size

    /** Focuses the list, so that keys scroll it. */
    fun focus() = scroll.focusInPlace()

    /** Shows the events that match [query], and returns their number. */
    fun filter(query: Query): Int {
        found = all.matching(query)
        limit = PAGE
        show()
        element.isHidden = found.size == 0 && !query.isEmpty
        return found.size
    }

    private fun show() {
        count.showText(countOf(found.size, all.size, "event"))
        body.patch(nodes.of(listOf(eventRows(log.name, found, scene.times, limit))))
        more.isHidden = found.size <= limit
        more.showText("Show more (${countText(found.size - limit)} left)")
    }
}

/** The [values] of a folder, see [valueRows]. */
internal class ValueList(private val values: List<Value>, scene: Scene) {
    private val nodes = PartNodes(scene.palette, scene.store::send)

    val element: HTMLElement = element("div", "card")

    init {
        filter(Query(""))
    }

    /** Shows the values that match [query], and returns their number. */
    fun filter(query: Query): Int {
        val rows = valueRows(values, query)
        element.patch(nodes.of(listOf(rows)))
        element.isHidden = rows.rows.isEmpty()
        return rows.rows.size
    }
}

/** The number of rows added at a time; a browser is slow with more than a few thousand. */
private const val PAGE = 300
