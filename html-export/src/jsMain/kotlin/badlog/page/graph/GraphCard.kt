package badlog.page.graph

import badlog.analysis.Graph
import badlog.analysis.Span
import badlog.page.dom.Icon
import badlog.page.dom.ResizeObserver
import badlog.page.dom.add
import badlog.page.dom.addIconButton
import badlog.page.dom.element
import badlog.page.dom.isHidden
import badlog.page.view.Scene
import badlog.plot.axis.YLimits
import badlog.plot.text.unitText
import kotlinx.browser.window
import org.w3c.dom.HTMLElement

/**
 * A graph with its title, legend and tools. It is drawn while it is near the screen, and its samples are not touched
 * before: derived ones are calculated when they are first looked at.
 *
 * @param origin what calculated it, where that was not the recording's own attributes; else empty.
 * @param height how tall a graph of numbers is; null for as tall as others.
 */
internal class GraphCard(val graph: Graph, private val scene: Scene, origin: String = "", private val height: Int? = null) {
    private val isShown = BooleanArray(graph.series.size) { true }
    private val legend = Legend(graph, isShown, ::redraw)
    private val statistics = StatisticsTable(graph, scene)
    private lateinit var host: HTMLElement
    private lateinit var statisticsButton: HTMLElement
    private var plot: Plot? = null
    private var overlay: CursorOverlay? = null
    private var resizing: ResizeObserver? = null
    private var statisticsTimer = 0
    private var shown: PlotContent? = null
    private var chosenY: Span? = null
    private lateinit var resetButton: HTMLElement

    /** Whether what is drawn is not what should be seen. */
    private var isStale = false

    val element: HTMLElement = element("section", "graph card") {
        setAttribute("data-name", graph.name)
        setAttribute("data-kind", if (graph.showsStates) "states" else "lines")
        add("header", "graph-head") {
            add("h3", "graph-title", graph.title).title = hintOf(graph)
            add("bdi", "unit graph-unit", unitText(graph.unit))
            if (origin.isNotEmpty()) add("span", "origin", origin).title = hintOf(graph)
            appendChild(legend.element)
            add("div", "graph-tools") {
                resetButton = addIconButton("reset-y", Icon.RESET, "Reset Y zoom") { resetY() }.apply { isHidden = true }
                if (!graph.showsStates) {
                    statisticsButton = addIconButton("statistics-toggle", Icon.SUM, "Statistics of the visible range") {
                        toggleStatistics()
                    }
                    statisticsButton.setAttribute("aria-expanded", "false")
                }
                addIconButton("save-image", Icon.IMAGE, "Save as an image") { saveImage() }
            }
        }
        host = add("div", "plot") {
            setAttribute("tabindex", "0")
            setAttribute("role", "group")
            setAttribute("aria-label", "Graph of ${graph.name}; arrow keys move the cursor")
        }
        appendChild(statistics.element.apply { isHidden = true })
    }

    /** Gives it the keys. */
    fun focus() = host.focus()

    /** Draws the graph if it is not drawn. */
    fun approach() {
        if (plot != null || host.clientWidth == 0) return
        if (graph.series.all { series -> series.data.y.all { it.isNaN() } }) {
            showEmpty()
            return
        }
        val content = if (graph.showsStates) {
            LaneContent(graph, scene.palette, isShown, scene.range.full.to)
        } else {
            LineContent(graph, scene.palette, isShown, scene.range.full.to, height)
        }
        content.limits.chosen = chosenY
        host.textContent = ""
        host.style.height = "${content.height}px"
        val drawn = Plot(scene, content, host, host.clientWidth) { overlay?.update() }
        host.add("div", "x-title", scene.xAxis.title).title = scene.xAxis.title
        val zoomY = { from: Double, to: Double -> showY(content) { choose(from, to) } }
        PlotGestures(drawn.over, scene, if (content.hasYAxis) zoomY else null) { if (chosenY != null) resetY() }
        overlay = CursorOverlay(graph, scene, content, drawn)
        plot = drawn
        shown = content
        isStale = false
        legend.update(scene.cursor)
        if (!statistics.element.isHidden) updateStatisticsSoon()
        resizing = ResizeObserver { drawn.resize(host.clientWidth) }.also { it.observe(host) }
    }

    /** Gives back what drawing takes. */
    fun leave() {
        val drawn = plot ?: return
        // Keeps its height, so that the page does not move below the reader.
        host.style.height = "${host.clientHeight}px"
        resizing?.disconnect()
        drawn.remove()
        host.textContent = ""
        plot = null
        shown = null
        overlay = null
    }

    private fun showY(content: PlotContent, change: YLimits.() -> Unit) {
        content.limits.change()
        chosenY = content.limits.chosen
        resetButton.isHidden = chosenY == null
        redraw()
    }

    private fun resetY() = shown?.let { showY(it) { chosen = null } }

    /** Draws the graph again with the colors of now. */
    fun repaint() {
        if (plot == null) return
        leave()
        approach()
    }

    /** Whether some of it is on the screen. */
    val isOnScreen: Boolean
        get() {
            if (plot == null) return false
            val box = host.getBoundingClientRect()
            return box.bottom > 0 && box.top < window.innerHeight
        }

    /** Says that the visible range has changed. */
    fun outdate() {
        isStale = plot != null
        if (!statistics.element.isHidden) updateStatisticsSoon()
    }

    /** Draws what is visible now, if that is not drawn already. */
    fun refresh() {
        if (isStale) redraw()
    }

    /** Shows the cursor and the values where it is. */
    fun updateCursor() {
        overlay?.update() ?: return
        legend.update(scene.cursor)
    }

    /** Draws again what is drawn, as it is now. */
    fun redraw() {
        isStale = false
        plot?.redraw()
        overlay?.update()
    }

    private fun showEmpty() {
        element.classList.add("is-empty")
        host.textContent = "No data"
    }

    private fun toggleStatistics() {
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

    private fun saveImage() {
        approach()
        plot?.let { saveGraphImage(graph, scene, isShown, it.canvas) }
    }

    private companion object {
        const val PAUSE_MILLISECONDS = 150
    }
}

/** The whole name, and what the file says of the topic besides. */
private fun hintOf(graph: Graph): String {
    val topic = graph.series[0].topic
    return listOf(graph.name, topic.type, topic.metadata).filter { it.isNotEmpty() }.joinToString("\n")
}
