package badlog.page.graph

import badlog.core.analysis.Graph
import badlog.core.analysis.GraphSeries
import badlog.core.analysis.Span
import badlog.page.dom.Icon
import badlog.page.dom.MenuEntry
import badlog.page.dom.ResizeObserver
import badlog.page.dom.add
import badlog.page.dom.addIconButton
import badlog.page.dom.addName
import badlog.page.dom.element
import badlog.page.dom.focusInPlace
import badlog.page.dom.isHidden
import badlog.page.dom.openMenu
import badlog.page.dom.showText
import badlog.page.export.imageEntries
import badlog.page.export.saveTable
import badlog.page.input.PointerListener
import badlog.page.view.PageBoard
import badlog.page.view.Scene
import badlog.page.xy.XyGraph
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.Plane
import badlog.viewer.choices.board.asBoardGraph
import badlog.viewer.choices.board.lineNames
import badlog.viewer.choices.board.shortTitles
import badlog.viewer.draw.axis.yParts
import badlog.viewer.draw.figure.Sheet
import badlog.viewer.draw.figure.graphHead
import badlog.viewer.session.gesture.PlotGestures
import badlog.viewer.shown.search.Query
import badlog.viewer.shown.table.CsvDraft
import badlog.viewer.text.unitText
import kotlinx.browser.window
import org.w3c.dom.HTMLElement

/**
 * A graph with its title, legend and tools. It is drawn while it is near the screen. Its samples are not touched before that:
 * derived ones are calculated on first use.
 *
 * @param origin what calculated it, if that was not the recording's own attributes; otherwise empty.
 * @param look its initial settings: which lines are hidden, which part of y is shown, and its height.
 * @param lines the board's names for the lines of [graph], in order.
 * @param onLook called with the settings that a person wants; the receiver stores them and calls [show]. Null if nobody stores
 * them.
 */
internal class GraphCard(
    val graph: Graph,
    private val scene: Scene,
    origin: String = "",
    look: BoardGraph = graph.asBoardGraph(),
    private val lines: List<String> = graph.lineNames,
    private val onLook: ((BoardGraph) -> Unit)? = null,
) {
    /** Its current settings. */
    var look: BoardGraph = look
        private set

    /** Its heading; on a board, as much of its path as tells it from the other graphs. */
    var title: String = graph.title
        set(value) {
            field = value
            heading.showText(value)
            host.setAttribute("aria-label", labelOf(value))
        }

    /** Its lines, and those of compared logs. */
    val series: List<GraphSeries> get() = drawn.graph.series

    private var drawn = CardLines(graph, lines, scene, ::toggle)
    private val statistics get() = drawn.statistics
    private val legend get() = drawn.legend
    private val xy = if (look.isXy && !graph.showsStates) XyGraph(scene, { this.look }, ::toggle, ::showPlane) else null
    private lateinit var heading: HTMLElement
    private lateinit var host: HTMLElement
    private lateinit var statisticsButton: HTMLElement
    private var plot: PlotCanvas? = null
    private var overlay: CursorOverlay? = null
    private var resizing: ResizeObserver? = null
    private var statisticsTimer = 0
    private var shown: GraphContent? = null
    private lateinit var resetButton: HTMLElement
    private lateinit var saveButton: HTMLElement
    private var pinButton: HTMLElement? = null
    private var addButton: HTMLElement? = null

    /** The element for its buttons. */
    lateinit var tools: HTMLElement
        private set

    private val isDrawn get() = plot != null || xy?.canvas != null

    /** Whether the picture is out of date. */
    private var isStale = false

    /** Whether it was drawn after its cursors were placed. */
    private var isMisplaced = false

    val element: HTMLElement = element("section", "graph card") {
        setAttribute("data-name", graph.name)
        setAttribute("data-kind", if (graph.showsStates) "states" else "lines")
        add("header", "graph-head") {
            heading = add("h3", "graph-title", graph.title)
            heading.title = hintOf(graph)
            graph.titleUnit.let { if (it.isNotEmpty()) add("bdi", "unit graph-unit", it) }
            if (origin.isNotEmpty()) add("span", "origin", origin).title = hintOf(graph)
            appendChild(xy?.legend ?: legend.element)
            tools = add("div", "graph-tools") {
                resetButton = addIconButton("reset-y", Icon.RESET, "Reset Y zoom") { showY(null) }
                statisticsButton = addIconButton("statistics-toggle", Icon.SUM, "Statistics of the visible range, or between the cursors") {
                    toggleStatistics()
                }
                statisticsButton.setAttribute("aria-expanded", "false")
                saveButton = addIconButton("save-image", Icon.IMAGE, "Export this graph") { offerFiles() }
                saveButton.setAttribute("aria-haspopup", "menu")
                if (onLook == null) {
                    addButton = addIconButton("add-to-graph", Icon.PLUS, "Add to graph…") { addToGraph() }
                    addButton?.setAttribute("aria-haspopup", "menu")
                    pinButton = addIconButton("pin", Icon.PIN, "Keep on the board (P)") { pin() }
                }
            }
        }
        host = add("div", "plot") {
            setAttribute("tabindex", "0")
            setAttribute("role", "group")
            setAttribute("aria-label", labelOf(graph.name))
            if (graph.showsStates) style.height = "${lanesHeight(graph)}px"
        }
        appendChild(statistics.element.apply { isHidden = true })
    }

    init {
        show(look)
        updatePin()
    }

    /** Puts it on the board, or removes it. */
    fun pin() = scene.board.change { withToggled(look) }

    /** Offers the graphs of the board, so that this one can be added to one of them. */
    private fun addToGraph() {
        val button = addButton ?: return
        val titled = scene.board.now.run { graphs.zip(shortTitles) }
        val graphs = titled.filterNot { (other, _) -> other.lines.containsAll(look.lines) }.take(PageBoard.MOST_OFFERED)
        if (graphs.isEmpty()) return scene.notice.say("The board has no other graph to add this to; keep one on it first.")
        val entries = graphs.map { (other, title) ->
            MenuEntry("Add to “$title”") { scene.board.change { withLines(other.id, look.lines) } }
        }
        openMenu(button, element.parentElement.unsafeCast<HTMLElement>(), entries)
    }

    /** Updates the button that shows whether it is on the board. */
    fun updatePin() {
        pinButton?.setAttribute("aria-pressed", scene.board.now.has(look).toString())
    }

    /** Shows it with the settings [wanted]. */
    fun show(wanted: BoardGraph) {
        look = wanted
        drawn.show(wanted.hidden)
        resetButton.isHidden = wanted.yRange == null && wanted.rightYRange == null
        redraw()
    }

    private fun change(wanted: BoardGraph) = onLook?.invoke(wanted) ?: show(wanted)

    private fun toggle(names: List<String>) =
        change(look.copy(hidden = if (names.any { it in look.hidden }) look.hidden - names.toSet() else look.hidden + names))

    /** Zooms y to [part] of what is shown now, as fractions from the top; null for all of it. */
    fun showY(part: Span?) {
        val parts = if (part == null) emptyList() else yParts(shown?.plot?.axes.orEmpty().map { it.shown }, part)
        if (parts.isNotEmpty()) {
            change(look.copy(yRange = parts[0], rightYRange = parts.getOrNull(1), sharesY = false))
        } else if (!resetButton.isHidden) {
            change(look.copy(yRange = null, rightYRange = null))
        }
    }

    private fun showPlane(plane: Plane?) = change(look.copy(xRange = plane?.x, yRange = plane?.y))

    /** Returns whether [query] finds it; of several lines, draws only those that are found by themselves, if there are any. */
    fun filter(query: Query): Boolean {
        if (drawn.search(query)) show(look)
        return drawn.isFoundBy(query)
    }

    /** Draws it again with the lines of the logs that are compared now. */
    fun renew() {
        val before = drawn
        drawn = CardLines(graph, lines, scene, ::toggle)
        if (xy == null) before.legend.element.replaceWith(drawn.legend.element) else xy.renew()
        drawn.statistics.element.isHidden = before.statistics.element.isHidden
        before.statistics.element.replaceWith(drawn.statistics.element)
        if (hasStatistics) statistics.update()
        drawn.show(look.hidden)
        repaint()
        legend.update(scene.cursor, scene.xAxis.unit)
    }

    /** Gives it the keyboard focus. */
    fun focus() = host.focus()

    /** Gives it the keyboard focus where it is; nothing scrolls. */
    fun focusInPlace() = host.focusInPlace()

    /** The width available for drawing it, in CSS pixels. */
    val room: Int get() = host.clientWidth

    /** If it is not drawn, creates its picture, [width] CSS pixels wide. Call [refresh] and [placeCursors] afterwards. */
    fun approach(width: Int = room) {
        if (isDrawn || width == 0) return
        if (xy != null && !xy.isEmpty) {
            xy.start(host)
            resizing = ResizeObserver { if (room != width) repaint() }.also { it.observe(host) }
            return
        }
        if (series.all { series -> series.data.y.all { it.isNaN() } }) {
            showEmpty()
            return
        }
        val content = newContent()
        host.textContent = ""
        host.style.height = "${content.height}px"
        val canvas = PlotCanvas(scene, content, host, width)
        host.addName(scene.xAxis.title, "x-title").title = scene.xAxis.title
        val target = GraphTarget(canvas.over, scene, lineShare = if (graph.showsStates) 0.0 else 1.0, ::showY)
        PointerListener(canvas.over, PlotGestures(target))
        overlay = CursorOverlay(drawn.colors, scene, content, canvas)
        plot = canvas
        shown = content
        isStale = true
        legend.update(scene.cursor, scene.xAxis.unit)
        if (!statistics.element.isHidden) updateStatisticsSoon()
        resizing = ResizeObserver {
            canvas.resize(host.clientWidth)
            overlay?.update()
        }.also { it.observe(host) }
    }

    private fun newContent() = GraphContent(drawn, scene) { look }

    /** Draws it on [sheet], with its current settings and the values at the cursor, whether or not it is near the screen. */
    fun drawOn(sheet: Sheet) {
        legend.update(scene.cursor, scene.xAxis.unit)
        val paths = xy?.takeIf { !it.isEmpty }
        sheet.graphHead(title, graph.titleUnit, paths?.legendOnSheet ?: legend.shown(hasColors = !graph.showsStates))
        if (paths != null) paths.drawOn(sheet) else drawGraphPlot(sheet, newContent(), scene)
    }

    /** Releases the resources for drawing. */
    fun leave() {
        if (xy?.canvas != null) {
            resizing?.disconnect()
            xy.leave(host)
        }
        if (plot == null) return
        // Keeps its height, so that the page does not move below the reader.
        host.style.height = "${host.clientHeight}px"
        resizing?.disconnect()
        host.textContent = ""
        plot = null
        shown = null
        overlay = null
    }

    /** Draws the graph again with the current colors. */
    fun repaint() {
        if (!isDrawn) return
        leave()
        approach()
        redraw()
    }

    /** Whether part of it is on the screen. */
    val isOnScreen: Boolean
        get() {
            if (!isDrawn) return false
            val box = host.getBoundingClientRect()
            return box.bottom > 0 && box.top < window.innerHeight
        }

    /** Marks it as out of date because the visible range has changed. */
    fun outdate() {
        isStale = isDrawn
        if (!statistics.element.isHidden) updateStatisticsSoon()
    }

    /** Draws what is visible now, unless it is up to date. */
    fun refresh() {
        if (!isStale) return
        isStale = false
        isMisplaced = true
        xy?.draw()
        plot?.redraw()
    }

    /** Puts the cursors at their places in the drawn picture. */
    fun placeCursors() {
        if (isMisplaced) overlay?.update()
        isMisplaced = false
    }

    /** Shows the cursor and the values at it. */
    fun updateCursor() {
        if (!statistics.element.isHidden && statistics.isOutdated) updateStatisticsSoon()
        xy?.updateCursor()
        overlay?.update() ?: return
        legend.update(scene.cursor, scene.xAxis.unit)
    }

    /** Redraws it if it is drawn. */
    fun redraw() {
        isStale = true
        refresh()
        placeCursors()
        statistics.repaint()
    }

    private fun showEmpty() {
        element.classList.add("is-empty")
        host.textContent = "No data"
    }

    val hasStatistics: Boolean get() = !statistics.element.isHidden

    /** Opens or closes the table of its statistics. */
    fun toggleStatistics() {
        val table = statistics.element
        table.isHidden = !table.isHidden
        statisticsButton.setAttribute("aria-expanded", (!table.isHidden).toString())
        if (!table.isHidden) statistics.update()
    }

    // Sorting all samples for the percentiles takes longer than a frame of a zoom may.
    private fun updateStatisticsSoon() {
        window.clearTimeout(statisticsTimer)
        statisticsTimer = window.setTimeout({ statistics.update() }, PAUSE_MILLISECONDS)
    }

    private fun offerFiles() {
        val table = MenuEntry("$title as a table (CSV)") {
            saveTable(scene, title, CsvDraft.of(scene.view, scene.range.now.takeIf { scene.range.isZoomed }, graph.series))
        }
        val entries = imageEntries(scene, title) { listOf(::drawOn) } + table
        openMenu(saveButton, element.parentElement.unsafeCast<HTMLElement>(), entries)
    }

    private fun labelOf(name: String) = "Graph of $name; arrow keys move the cursor"

    private companion object {
        const val PAUSE_MILLISECONDS = 150
    }
}

/** The unit beside its title; empty if its lines have several units, which the legend then shows for each line. */
internal val Graph.titleUnit: String get() = if (series.all { it.unit == unit }) unitText(unit) else ""
