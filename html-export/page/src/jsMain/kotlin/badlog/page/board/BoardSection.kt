package badlog.page.board

import badlog.page.dom.Icon
import badlog.page.dom.MenuEntry
import badlog.page.dom.add
import badlog.page.dom.addIconButton
import badlog.page.dom.bringIntoSight
import badlog.page.dom.element
import badlog.page.dom.isDisabled
import badlog.page.dom.isHidden
import badlog.page.dom.openMenu
import badlog.page.dom.showText
import badlog.page.graph.GraphCard
import badlog.page.graph.VisibleGraphs
import badlog.page.view.PageBoard
import badlog.page.view.Scene
import badlog.page.view.graphsOf
import badlog.signals.pose.Pose
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.BoardLines
import badlog.viewer.choices.board.GraphHeight
import badlog.viewer.choices.board.shortTitles
import badlog.viewer.input.KeyAction
import badlog.viewer.session.GraphOffer
import badlog.viewer.session.GraphOffers
import badlog.viewer.shown.search.Query
import badlog.viewer.state.GraphChange
import badlog.viewer.text.countOf
import kotlinx.browser.document
import kotlinx.browser.window
import org.w3c.dom.HTMLElement

/**
 * The section with the graphs that the reader put together, and actions for all of them.
 *
 * @param layouts the buttons that save the board and open another one.
 */
internal class BoardSection(
    private val scene: Scene,
    private val graphs: VisibleGraphs,
    private val topics: TopicDialog,
    layouts: HTMLElement,
) {
    private val board = scene.board
    private val items = ArrayList<BoardItem>()
    private var query = Query("")
    private lateinit var count: HTMLElement
    private lateinit var hint: HTMLElement
    private lateinit var body: HTMLElement
    private lateinit var add: HTMLElement
    private lateinit var undo: HTMLElement
    private lateinit var redo: HTMLElement
    private lateinit var clear: HTMLElement

    val element: HTMLElement = element("section", "board") {
        id = "board"
        setAttribute("aria-label", "Board")
        add("header", "graph-head") {
            add("h2", "findings-title", "Board")
            count = add("span", "unit") { setAttribute("role", "status") }
            hint = add("span", "unit board-hint", "Pin graphs (P) to see them together here.")
            add("div", "graph-tools") {
                add = addIconButton("", Icon.PLUS, "Add topics") { topics.open() }.apply { id = "add-topics" }
                undo = addIconButton("", Icon.UNDO, "Undo (${KeyAction.UNDO.shortcut})") { board.undo() }.apply { id = "undo" }
                redo = addIconButton("redo", Icon.UNDO, "Redo (${KeyAction.REDO.shortcut})") { board.redo() }.apply { id = "redo" }
                val start = "Start board: the graphs with which this page opened"
                addIconButton("", Icon.START, start) { board.startAgain() }.id = "start-board"
                appendChild(layouts)
                clear = addIconButton("", Icon.CLOSE, "Remove all graphs") { board.send(GraphChange.ShowOnly(emptyList())) }
                clear.id = "clear-board"
            }
        }
        body = add("div", "folder-body")
    }

    init {
        board.onChange(::show)
        show()
    }

    /** All cards of the board, in order. */
    val cards: List<GraphCard> get() = items.flatMap { it.cards }

    /** Returns the graph of the board that contains the element [part]; null if there is none. */
    fun itemOf(part: HTMLElement): BoardItem? = items.find { it.element.contains(part) }

    /**
     * Returns the graph of the board at height [y] in the window; null if there is none.
     *
     * The second value is the distance of [y] from the graph's top, as a fraction of its height.
     */
    fun itemAt(y: Double): Pair<BoardItem, Double>? = items.firstNotNullOfOrNull { item ->
        val box = item.element.getBoundingClientRect()
        if (y in box.top..box.bottom) item to (y - box.top) / box.height else null
    }

    /** Returns the id of the graph after [item]; null if there is none. */
    fun after(item: BoardItem): Int? = items.getOrNull(items.indexOf(item) + 1)?.spec?.id

    /** Focuses the graph with the id [id], otherwise the button that adds graphs. */
    fun focus(id: Int?) = items.find { it.spec.id == id }?.cards?.first()?.focus() ?: add.focus()

    /** Scrolls to the graph with the id [id] if less than half of it is in sight. */
    fun keepInSight(id: Int) {
        val moved = items.find { it.spec.id == id }?.element ?: return
        val box = moved.getBoundingClientRect()
        if ((box.top + box.bottom) / 2 !in 0.0..window.innerHeight.toDouble()) moved.bringIntoSight()
    }

    /** Shows only the graphs that match [query]. */
    fun filter(query: Query) {
        this.query = query
        showFound()
    }

    /** Scrolls to the board. */
    fun bringIntoSight() = element.bringIntoSight()

    private fun show() {
        val wanted = board.now.graphs
        val focused = document.activeElement.unsafeCast<HTMLElement?>()
        val before = items.associateBy { it.spec.id }
        val shown = wanted.map { spec -> before[spec.id]?.takeIf { it.fits(spec) } ?: BoardItem(spec, scene, ::openMenu) }
        for (item in items - shown.toSet()) remove(item)
        for (item in shown - items.toSet()) for (card in item.cards) graphs.add(card)
        items.clear()
        items += shown
        val titles = board.now.shortTitles
        shown.forEachIndexed { i, item ->
            item.show(wanted[i])
            for (card in item.cards) card.title = titles[i]
            // An element that is moved loses the focus.
            val here = body.children.item(i)
            if (here != item.element) body.insertBefore(item.element, here)
        }
        if (focused != null && focused != document.activeElement) focused.focus()
        for (card in cards) if (card.look.sharesY) card.redraw()
        graphs.updatePins()
        showFound()
        hint.isHidden = wanted.isNotEmpty()
        clear.isDisabled = wanted.isEmpty()
        undo.isDisabled = !board.canUndo
        redo.isDisabled = !board.canRedo
    }

    private fun showFound() {
        for (item in items) item.filter(query)
        val found = items.count { !it.element.isHidden }
        count.showText(if (items.isEmpty()) "" else countOf(found, items.size, "graph"))
    }

    private fun remove(item: BoardItem) {
        for (card in item.cards) graphs.remove(card)
        item.element.remove()
    }

    private fun openMenu(item: BoardItem, button: HTMLElement) =
        openMenu(button, item.element, boardMenu(board, item.spec, item, topics, scene.paths.poses))
}

/**
 * Returns the menu entries for [graph] of [board], which [item] shows.
 *
 * [topics] is the dialog that adds topics to it; [poses] are the log's poses.
 */
internal fun boardMenu(board: PageBoard, graph: BoardGraph, item: BoardItem, topics: TopicDialog, poses: List<Pose>): List<MenuEntry> {
    val offers = GraphOffers(board.now, graph, poses)
    val numbers = item.cards.firstOrNull { !it.graph.showsStates }
    fun entries(offered: List<GraphOffer>) = offered.map { MenuEntry(it.label, it.isOn) { board.send(it.change) } }
    return buildList {
        addAll(entries(offers.moves))
        add(MenuEntry("Add topics…") { topics.open(graph.id) })
        addAll(entries(offers.additions(board.now.shortTitles).take(PageBoard.MAX_OFFERED) + listOfNotNull(offers.separation)))
        if (numbers != null) addAll(entries(offers.heights(GraphHeight.MEDIUM) + offers.planes))
        addAll(entries(offers.origins))
        if (numbers != null) addAll(entries(offers.limits(numbers.picture.axes.map { it.shown })))
        addAll(entries(listOf(offers.removal)))
    }
}

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

/** Adds a button that puts [graph] on [board] or removes it. The graph need not be drawn. */
internal fun HTMLElement.addPin(board: PageBoard, graph: BoardGraph): HTMLElement =
    addIconButton("pin", Icon.PIN, "Keep ${graph.title} on the board") { board.send(GraphChange.Toggle(graph)) }.also { button ->
        fun update() = button.setAttribute("aria-pressed", board.now.has(graph).toString())
        board.onChange(::update)
        update()
    }
