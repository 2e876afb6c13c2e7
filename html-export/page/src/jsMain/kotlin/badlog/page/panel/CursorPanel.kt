package badlog.page.panel

import badlog.core.analysis.GraphSeries
import badlog.page.dom.Icon
import badlog.page.dom.LocalStorage
import badlog.page.dom.add
import badlog.page.dom.addIconButton
import badlog.page.dom.element
import badlog.page.dom.isHidden
import badlog.page.parts.PartNodes
import badlog.page.parts.patch
import badlog.page.view.Frame
import badlog.page.view.Scene
import badlog.viewer.panel.Button
import badlog.viewer.panel.CursorLine
import badlog.viewer.panel.PartIcon
import badlog.viewer.panel.cursorPanel
import badlog.viewer.shown.cursor.CursorValues
import badlog.viewer.shown.search.Query
import badlog.viewer.state.GraphChange
import badlog.viewer.text.unitText
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
    private lateinit var body: HTMLElement
    private val nodes = PartNodes(scene.palette, scene.store::send)
    private val frame = Frame(::update)
    private var query = Query("")
    private var lines = emptyList<CursorLine>()
    private var values = CursorValues(emptyList(), scene.xAxis)

    val element: HTMLElement = element("aside", "cursor-panel card") {
        id = "cursor-values"
        setAttribute("aria-label", "Values at the cursor")
        add("header", "graph-head") {
            add("h2", "findings-title", "Values")
            add("div", "graph-tools") { addIconButton("", Icon.CLOSE, "Close the values (V)") { toggle() } }
        }
        body = add("div", "cursor-panel-body")
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
        val pinned = scene.board.now.graphs.mapNotNullTo(HashSet()) { it.lines.singleOrNull() }
        val wanted = if (query.isEmpty) {
            shown()
        } else {
            all().filter {
                query.matches("${it.topic.name} ${unitText(it.unit)}", scene.traitsOf(it, query))
            }
        }
        lines = wanted.distinctBy { it.topic.name to it.isDerived to it.name }.map { line ->
            val name = if (line.isDerived) line.name else line.topic.name
            // The name of a topic derived by an attribute may exist only in its graph.
            val pin = if (scene.board.lines[name] ==
                null
            ) {
                null
            } else {
                Button("Keep on the board", GraphChange.ToggleOwn(name), PartIcon.PIN, isOn = name in pinned)
            }
            CursorLine(name, line, pin)
        }
        values = CursorValues(lines.map { it.line }, scene.xAxis)
        frame.ask()
    }

    private fun setOpen(isOpen: Boolean) {
        element.isHidden = !isOpen
        button.firstElementChild?.setAttribute("aria-expanded", isOpen.toString())
    }

    private fun update() {
        val x = scene.cursor.x.takeIf { scene.cursor.isPlaced }
        body.patch(nodes.of(cursorPanel(lines, values, x, x?.let(scene::xText).orEmpty())))
    }

    private companion object {
        const val KEY = "values"
    }
}
