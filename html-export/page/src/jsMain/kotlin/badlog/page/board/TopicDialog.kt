package badlog.page.board

import badlog.page.dom.Dialog
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.addTextField
import badlog.page.dom.showText
import badlog.page.view.Scene
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.pathGraphs
import badlog.viewer.choices.board.shortTitles
import badlog.viewer.choices.board.xyGraphs
import badlog.viewer.shown.search.Query
import badlog.viewer.state.GraphChange
import badlog.viewer.text.countText
import badlog.viewer.text.unitText
import org.w3c.dom.HTMLElement
import org.w3c.dom.HTMLInputElement

/** The dialog that adds topics by name to the board, or to one of its graphs. */
internal class TopicDialog(private val scene: Scene) {
    private val board = scene.board
    private lateinit var input: HTMLInputElement
    private lateinit var list: HTMLElement
    private lateinit var rest: HTMLElement

    /** The graph that receives the topics; null to give each topic its own graph. */
    private var graph: Int? = null

    private val dialog = Dialog("topic-dialog", "topic-dialog") {
        add("div", "formula-body") {
            input = addTextField("formula-input", "topic-search", "Search topics", "Search topics")
            list = add("ul", "topic-list")
            rest = add("p", "unit") { setAttribute("role", "status") }
        }
    }

    val element: HTMLElement = dialog.element

    init {
        input.type = "search"
        input.addEventListener("input", { list() })
    }

    /** Opens the dialog for the board's graph with the id [graph]; null for new graphs. */
    fun open(graph: Int? = null) {
        if (dialog.isOpen) return
        this.graph = graph
        val name = board.now.run { graphs.indexOfFirst { it.id == graph }.let(shortTitles::getOrNull) }
        dialog.title = if (name == null) "Add topics to the board" else "Add topics to “$name”"
        dialog.open()
        input.value = ""
        list()
        input.focus()
    }

    private fun list() {
        val query = Query(input.value)
        val found = board.lines.names.filter { name ->
            val line = board.lines[name]
            query.matches("$name ${line?.let { unitText(it.unit) }.orEmpty()}", line?.let { scene.traitsOf(it, query) }.orEmpty())
        }
        list.textContent = ""
        // Paths and XY plots are always graphs of their own.
        val graphs = if (graph == null) pathGraphs(scene.paths.poses, query) + xyGraphs(numbers(), input.value) else emptyList()
        graphs.forEach(::addGraph)
        for (name in found.take(MAX_LISTED)) {
            list.add("li") {
                addButton("text-button", "") {}.apply {
                    add("bdi", "", name)
                    board.lines[name]?.let { add("bdi", "unit", unitText(it.unit)) }
                    setAttribute("aria-pressed", isShown(name).toString())
                    addEventListener("click", {
                        toggle(name)
                        setAttribute("aria-pressed", isShown(name).toString())
                    })
                }
            }
        }
        val left = found.size - MAX_LISTED
        rest.showText(
            when {
                found.isEmpty() && graphs.isEmpty() -> "Nothing matches."
                left > 0 -> "${countText(left)} more; type a part of the name."
                else -> ""
            },
        )
    }

    private fun addGraph(offered: BoardGraph) = list.add("li") {
        addButton("text-button", offered.title) {}.apply {
            fun update() = setAttribute("aria-pressed", board.now.has(offered).toString())
            update()
            addEventListener("click", {
                board.send(GraphChange.Toggle(offered))
                update()
            })
        }
    }

    /** Returns the topics that an XY plot can draw. */
    private fun numbers() = board.lines.names.filter { name -> board.lines[name]?.states == null }

    private fun isShown(name: String) =
        board.now.graphs.any { if (graph == null) it.lines == listOf(name) else it.id == graph && name in it.lines }

    private fun toggle(name: String) = board.send(graph?.let { GraphChange.ToggleLine(it, name) } ?: GraphChange.ToggleOwn(name))
}

/** The maximum number of names listed at once. */
private const val MAX_LISTED = 100
