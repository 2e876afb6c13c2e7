package badlog.page.panel

import badlog.core.analysis.GraphSeries
import badlog.page.dom.Icon
import badlog.page.dom.LocalStorage
import badlog.page.dom.add
import badlog.page.dom.addIconButton
import badlog.page.dom.addName
import badlog.page.dom.element
import badlog.page.dom.isHidden
import badlog.page.dom.showText
import badlog.page.view.Frame
import badlog.page.view.Scene
import badlog.viewer.shown.cursor.CursorValues
import badlog.viewer.shown.cursor.indexAt
import badlog.viewer.shown.cursor.textOf
import badlog.viewer.shown.search.Query
import badlog.viewer.state.GraphChange
import badlog.viewer.text.countText
import badlog.viewer.text.exactText
import badlog.viewer.text.numberText
import badlog.viewer.text.unitText
import badlog.viewer.text.withUnit
import org.w3c.dom.HTMLElement

/**
 * The values of many topics at the cursor, most recently changed first. The browser remembers whether it is open.
 *
 * @param shown the lines of the graphs on the screen.
 * @param all the lines that a search may find.
 * @param beforeOpening closes the other panel, which has the same place.
 */
internal class CursorPanel(
    private val scene: Scene,
    private val shown: () -> List<GraphSeries>,
    private val all: () -> List<GraphSeries>,
    private val beforeOpening: () -> Unit,
) {
    private lateinit var place: HTMLElement
    private lateinit var hint: HTMLElement
    private lateinit var body: HTMLElement
    private val rows = ArrayList<Row>()
    private val frame = Frame(::update)
    private var query = Query("")
    private var lines = emptyList<GraphSeries>()
    private var values = CursorValues(lines, scene.xAxis)
    private var pinned = emptySet<String>()

    val element: HTMLElement = element("aside", "cursor-panel card") {
        id = "cursor-values"
        setAttribute("aria-label", "Values at the cursor")
        add("header", "graph-head") {
            add("h2", "findings-title", "Values")
            place = add("span", "unit")
            add("div", "graph-tools") { addIconButton("", Icon.CLOSE, "Close the values (V)") { toggle() } }
        }
        hint = add("p", "cursor-panel-hint")
        body = add("div", "cursor-panel-rows") {
            setAttribute("tabindex", "0")
            setAttribute("role", "group")
            setAttribute("aria-label", "Values")
        }
    }

    /** The button that opens and closes the panel. */
    val button: HTMLElement = element("div", "values-button") {
        addIconButton("", Icon.LIST, "Values at the cursor (V)") { toggle() }.id = "values-button"
    }

    init {
        setOpen(LocalStorage[KEY] == "open")
        scene.cursor.onChange { if (!element.isHidden) frame.ask() }
    }

    /** Whether the panel is visible; only then it follows the cursor. */
    val isOpen: Boolean get() = !element.isHidden

    /** Opens or closes it. */
    fun toggle() {
        if (element.isHidden) beforeOpening()
        setOpen(element.isHidden)
        refresh()
        LocalStorage[KEY] = if (element.isHidden) "" else "open"
    }

    /** Shows the topics that [query] matches; without a search, the topics in the graphs. */
    fun filter(query: Query) {
        this.query = query
        refresh()
    }

    /** Lists the current topics again. */
    fun refresh() {
        if (element.isHidden) return
        lines =
            if (query.isEmpty) {
                shown()
            } else {
                all().filter {
                    query.matches("${it.topic.name} ${unitText(it.unit)}", scene.traitsOf(it, query))
                }
            }
        lines = lines.distinctBy { it.topic.name to it.isDerived to it.name }
        values = CursorValues(lines, scene.xAxis)
        pinned = scene.board.now.graphs.mapNotNullTo(HashSet()) { it.lines.singleOrNull() }
        frame.ask()
    }

    private fun setOpen(isOpen: Boolean) {
        element.isHidden = !isOpen
        button.firstElementChild?.setAttribute("aria-expanded", isOpen.toString())
    }

    private fun update() {
        val x = scene.cursor.x
        place.showText(if (scene.cursor.isPlaced) scene.xText(x) else "")
        val found = values.at(x)
        found.take(MAX_ROWS).forEachIndexed { index, value ->
            if (index == rows.size) rows += Row(body)
            val line = lines[value.line]
            rows[index].show(line, value.hasChanged, x, isPinned = line.called in pinned)
        }
        for (index in found.size until rows.size) rows[index].element.isHidden = true
        val more = lines.size - MAX_ROWS
        hint.showText(
            when {
                lines.isEmpty() -> "No topic matches."
                !scene.cursor.isPlaced -> "Point at a graph, or click it."
                more > 0 -> "And ${countText(more)} more: search to find them."
                else -> ""
            },
        )
    }

    private inner class Row(parent: HTMLElement) {
        private lateinit var name: HTMLElement
        private lateinit var value: HTMLElement
        private lateinit var pin: HTMLElement
        private var called = ""
        private var exactValue = { "" }

        val element: HTMLElement = parent.add("div", "cursor-value") {
            name = addName(className = "cursor-value-name")
            value = add("bdi", "cursor-value-text") { addEventListener("pointerenter", { title = exactValue() }) }
            pin = addIconButton("pin", Icon.PIN, "Keep on the board") { scene.store.send(GraphChange.ToggleOwn(called)) }
        }

        fun show(line: GraphSeries, hasChanged: Boolean, x: Double, isPinned: Boolean) {
            element.isHidden = false
            element.classList.toggle("is-changed", hasChanged)
            called = line.called
            name.showText(called)
            name.title = called
            // The name of a topic derived by an attribute may exist only in its graph.
            pin.isHidden = scene.board.lines[called] == null
            pin.setAttribute("aria-pressed", isPinned.toString())
            exactValue = { line.textOf(line.indexAt(x)) { withUnit(exactText(it), line.unit) } }
            // A tooltip that is still there shows the former value.
            value.removeAttribute("title")
            value.showText(line.textOf(line.indexAt(x)) { withUnit(numberText(it), line.unit) })
        }
    }

    private val GraphSeries.called: String get() = if (isDerived) name else topic.name

    private companion object {
        const val KEY = "values"

        /** The maximum number of rows; more cannot be read while the cursor moves. */
        const val MAX_ROWS = 200
    }
}
