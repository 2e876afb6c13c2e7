package badlog.page.graph

import badlog.core.analysis.Span
import badlog.page.dom.ResizeObserver
import badlog.page.dom.addName
import badlog.page.input.PointerListener
import badlog.page.view.Scene
import badlog.page.xy.XyGraph
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.draw.plot.PlotAxis
import badlog.viewer.session.gesture.PlotGestures
import kotlinx.browser.window
import org.w3c.dom.HTMLElement

/**
 * What a card draws in [host] while that is near the screen: [xy], if it has anything to draw, or else lines or lanes.
 *
 * @param lines returns the current lines of the graph.
 * @param look returns its current settings.
 * @param onY called with the part of the visible y that is to be shown; null for all of it.
 * @param onPlot called when lines or lanes are about to be drawn, so that the legend and the statistics show the same.
 */
internal class CardPicture(
    private val host: HTMLElement,
    private val scene: Scene,
    private val xy: XyGraph?,
    private val lines: () -> CardLines,
    private val look: () -> BoardGraph,
    private val onY: (Span?) -> Unit,
    private val onPlot: () -> Unit,
) {
    private var plot: PlotCanvas? = null
    private var overlay: CursorOverlay? = null
    private var resizing: ResizeObserver? = null
    private var shown: GraphContent? = null

    /** Whether it is out of date. */
    private var isStale = false

    /** Whether it was drawn after its cursors were placed. */
    private var isMisplaced = false

    /** Whether it is drawn. */
    val isDrawn: Boolean get() = plot != null || xy?.canvas != null

    /** The y axes that were drawn last. */
    val axes: List<PlotAxis> get() = shown?.plot?.axes.orEmpty()

    /** The width available for drawing it, in CSS pixels. */
    val room: Int get() = host.clientWidth

    /** If it is not drawn, creates it, [width] CSS pixels wide. Call [refresh] and [placeCursors] afterwards. */
    fun approach(width: Int = room) {
        if (isDrawn || width == 0) return
        if (xy != null && !xy.isEmpty) {
            xy.start(host)
            resizing = ResizeObserver { if (room != width) repaint() }.also { it.observe(host) }
            return
        }
        val graph = lines().graph
        if (graph.series.all { series -> series.data.y.all { it.isNaN() } }) {
            showEmpty()
            return
        }
        val content = newContent()
        host.textContent = ""
        host.style.height = "${content.height}px"
        val canvas = PlotCanvas(scene, content, host, width)
        host.addName(scene.xAxis.title, "x-title").title = scene.xAxis.title
        val target = GraphTarget(canvas.over, scene, lineShare = if (graph.showsStates) 0.0 else 1.0, onY)
        PointerListener(canvas.over, PlotGestures(target))
        overlay = CursorOverlay(lines().colors, scene, content, canvas)
        plot = canvas
        shown = content
        isStale = true
        onPlot()
        resizing = ResizeObserver {
            canvas.resize(host.clientWidth)
            overlay?.update()
        }.also { it.observe(host) }
    }

    /** Returns what lines or lanes show now. */
    fun newContent(): GraphContent = GraphContent(lines(), scene, look)

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

    /** Draws it again with the current colors. */
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
    }

    /** Draws what is visible now, unless it is up to date. */
    fun refresh() {
        if (!isStale) return
        isStale = false
        isMisplaced = true
        xy?.draw()
        plot?.redraw()
    }

    /** Puts the cursors at their places in what is drawn. */
    fun placeCursors() {
        if (isMisplaced) overlay?.update()
        isMisplaced = false
    }

    /** Moves the cursors to their places. Returns whether it has lines or lanes. */
    fun updateCursor(): Boolean {
        xy?.updateCursor()
        overlay?.update()
        return overlay != null
    }

    /** Draws it again if it is drawn. */
    fun redraw() {
        isStale = true
        refresh()
        placeCursors()
    }

    private fun showEmpty() {
        host.parentElement?.classList?.add("is-empty")
        host.textContent = "No data"
    }
}
