package badlog.page.graph

import badlog.core.analysis.Graph
import badlog.core.analysis.GraphSeries
import badlog.core.analysis.PixelColumns
import badlog.core.analysis.Span
import badlog.page.dom.Icon
import badlog.page.dom.MenuEntry
import badlog.page.dom.add
import badlog.page.dom.addIconButton
import badlog.page.dom.element
import badlog.page.dom.focusInPlace
import badlog.page.dom.isHidden
import badlog.page.dom.openMenu
import badlog.page.dom.showText
import badlog.page.export.imageEntries
import badlog.page.export.saveTable
import badlog.page.view.PageBoard
import badlog.page.view.Scene
import badlog.page.xy.XyGraph
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.Plane
import badlog.viewer.choices.board.asBoardGraph
import badlog.viewer.choices.board.lineNames
import badlog.viewer.choices.board.shortTitles
import badlog.viewer.draw.axis.yParts
import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.figure.Sheet
import badlog.viewer.draw.figure.graphHead
import badlog.viewer.draw.figure.xTitle
import badlog.viewer.draw.plot.PlotMargins
import badlog.viewer.draw.plot.drawCursors
import badlog.viewer.draw.plot.drawPlot
import badlog.viewer.draw.plot.drawSamples
import badlog.viewer.shown.search.Query
import badlog.viewer.shown.table.CsvDraft
import badlog.viewer.state.GraphChange
import badlog.viewer.text.unitText
import kotlinx.browser.window
import org.w3c.dom.HTMLElement

/**
 * A graph with its title, legend and tools. It is drawn while it is near the screen. Its samples are not read before that, because derived
 * samples are calculated on first use.
 *
 * @param origin the origin of a calculated graph; empty for a logged graph, and for one derived by the recording's own attributes.
 * @param look its initial settings: the hidden lines, the visible part of y, and the height.
 * @param lines the board's names for the lines of [graph], in order.
 * @param onLook called with the settings that a person wants; the receiver stores them and calls [show]. Null if they are not
 * stored.
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

    /** Its heading. On a board, it contains as much of the path as distinguishes the graph from the others. */
    var title: String = graph.title
        set(value) {
            field = value
            heading.showText(value)
            host.setAttribute("aria-label", labelOf(value))
        }

    /** Its lines, and the lines of compared logs. */
    val series: List<GraphSeries> get() = drawn.graph.series

    private var drawn = CardLines(graph, lines, scene, ::toggle)
    private val statistics get() = drawn.statistics
    private val legend get() = drawn.legend
    private val xy = if (look.isXy && !graph.showsStates) XyGraph(scene, { this.look }, ::toggle, ::showPlane) else null
    private lateinit var heading: HTMLElement
    private lateinit var host: HTMLElement
    private lateinit var statisticsButton: HTMLElement
    private var statisticsTimer = 0
    private lateinit var resetButton: HTMLElement
    private lateinit var saveButton: HTMLElement
    private var boardButtons: BoardButtons? = null

    /** The element for its buttons. */
    lateinit var tools: HTMLElement
        private set

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
                if (onLook == null) boardButtons = BoardButtons(this, scene) { this@GraphCard.look }
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

    /** The drawing of the graph. */
    val picture: CardPicture = CardPicture(host, scene, xy, { drawn }, { this.look }, ::showY) {
        legend.update(scene.cursor, scene.xAxis.unit)
        if (hasStatistics) updateStatisticsSoon()
    }

    init {
        show(look)
        updatePin()
    }

    /** Puts it on the board, or removes it from there. */
    fun pin() {
        boardButtons?.togglePin()
    }

    /** Updates the button that shows whether it is on the board. */
    fun updatePin() {
        boardButtons?.update()
    }

    /** Shows it with the settings [wanted]. */
    fun show(wanted: BoardGraph) {
        look = wanted
        drawn.show(wanted.hidden)
        resetButton.isHidden = !wanted.isYFixed
        redraw()
    }

    private fun change(wanted: BoardGraph) = onLook?.invoke(wanted) ?: show(wanted)

    private fun toggle(names: List<String>) =
        change(look.copy(hidden = if (names.any { it in look.hidden }) look.hidden - names.toSet() else look.hidden + names))

    /** Zooms y to [part] of the visible range, as fractions from the top; null for all of it. */
    fun showY(part: Span?) {
        val parts = if (part == null) emptyList() else yParts(picture.axes.map { it.shown }, part)
        if (parts.isNotEmpty()) {
            change(look.copy(yRange = parts[0], rightYRange = parts.getOrNull(1), sharesY = false))
        } else if (!resetButton.isHidden) {
            change(look.copy(yRange = null, rightYRange = null))
        }
    }

    private fun showPlane(plane: Plane?) = change(look.copy(xRange = plane?.x, yRange = plane?.y))

    /** Returns whether [query] matches it. If some of its lines match by themselves, draws only these lines. */
    fun filter(query: Query): Boolean {
        if (drawn.search(query)) show(look)
        return drawn.isFoundBy(query)
    }

    /** Redraws it with the lines of the currently compared logs. */
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

    /** Gives it the keyboard focus without scrolling. */
    fun focusInPlace() = host.focusInPlace()

    /** Draws it on [sheet], with its current settings and the values at the cursor. It need not be near the screen. */
    fun drawOn(sheet: Sheet) {
        legend.update(scene.cursor, scene.xAxis.unit)
        val paths = xy?.takeIf { !it.isEmpty }
        sheet.graphHead(title, graph.titleUnit, paths?.legendOnSheet ?: legend.shown(hasColors = !graph.showsStates))
        if (paths != null) paths.drawOn(sheet) else drawGraphPlot(sheet, picture.newContent(), scene)
    }

    /** Draws the graph again with the current colors. */
    fun repaint() {
        if (!picture.isDrawn) return
        picture.repaint()
        statistics.repaint()
    }

    /** Marks it as out of date because the visible range has changed. */
    fun outdate() {
        picture.outdate()
        if (hasStatistics) updateStatisticsSoon()
    }

    /** Shows the cursor and the values at it. */
    fun updateCursor() {
        if (hasStatistics && statistics.isOutdated) updateStatisticsSoon()
        if (picture.updateCursor()) legend.update(scene.cursor, scene.xAxis.unit)
    }

    /** Redraws it if it is drawn. */
    fun redraw() {
        picture.redraw()
        statistics.repaint()
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
}

/** The unit beside the title; empty if its lines have several units, which the legend then shows for each line. */
internal val Graph.titleUnit: String get() = if (series.all { it.unit == unit }) unitText(unit) else ""

/** Draws [content] with the cursors over it and the title of x below. */
internal fun drawGraphPlot(sheet: Sheet, content: GraphContent, scene: Scene) {
    val now = scene.range.now
    val colors = PenColors.LIGHT
    sheet.part(content.height.toDouble()) { pen ->
        val frame = PlotMargins.frameOf(sheet.width, content.height, now, pen.density)
        val plot = content.plotIn(frame, PixelColumns(frame.width.toInt()), pen.density)
        pen.drawPlot(frame, plot, scene.marks, colors, PlotMargins.BOTTOM * pen.density)
        // A figure must not show where the pointer happens to be.
        pen.drawCursors(frame, scene.cursor.now.withoutPointer, colors)
        scene.cursor.now.pinned?.let { pen.drawSamples(frame, plot, content.drawnLines, it, colors) }
    }
    sheet.xTitle(scene.xAxis.title)
}

/**
 * The buttons among [tools] that put a graph on the board, on its own or into another graph.
 *
 * @param look returns the graph with its current settings.
 */
internal class BoardButtons(tools: HTMLElement, private val scene: Scene, private val look: () -> BoardGraph) {
    private val add: HTMLElement = tools.addIconButton("add-to-graph", Icon.PLUS, "Add to graph…") { offerGraphs() }
        .apply { setAttribute("aria-haspopup", "menu") }
    private val pin: HTMLElement = tools.addIconButton("pin", Icon.PIN, "Keep on the board (P)") { togglePin() }

    /** Puts the graph on the board, or removes it. */
    fun togglePin() = scene.store.send(GraphChange.Toggle(look()))

    /** Shows whether the graph is on the board. */
    fun update() = pin.setAttribute("aria-pressed", scene.board.now.has(look()).toString())

    /** Lists the graphs of the board to which this one can be added. */
    private fun offerGraphs() {
        val titled = scene.board.now.run { graphs.zip(shortTitles) }
        val graphs = titled.filterNot { (other, _) -> other.lines.containsAll(look().lines) }.take(PageBoard.MAX_OFFERED)
        if (graphs.isEmpty()) return scene.notice.say("The board has no other graph to add this to; keep one on it first.")
        val entries = graphs.map { (other, title) ->
            MenuEntry("Add to “$title”") { scene.store.send(GraphChange.AddLines(other.id, look().lines)) }
        }
        openMenu(add, add.closest(".graph")?.parentElement.unsafeCast<HTMLElement>(), entries)
    }
}

private const val PAUSE_MILLISECONDS = 150
