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
 * The drawing of a card in [host], present while [host] is near the screen. It shows [xy] if that is not empty, otherwise lines or lanes.
 *
 * @param lines returns the current lines of the graph.
 * @param look returns the graph's current settings.
 * @param onY called with the part of the visible y to show; null for all of it.
 * @param onPlot called before lines or lanes are drawn, so that the legend and the statistics show the same.
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

    /** Whether the drawing is out of date. */
    private var isStale = false

    /** Whether the drawing is newer than the places of its cursors. */
    private var isMisplaced = false

    val isDrawn: Boolean get() = plot != null || xy?.canvas != null

    /** The y axes that were drawn last. */
    val axes: List<PlotAxis> get() = shown?.plot?.axes.orEmpty()

    /** The width available for the drawing, in CSS pixels. */
    val room: Int get() = host.clientWidth

    /** Creates the drawing if it is missing, [width] CSS pixels wide. Call [refresh] and [placeCursors] afterwards. */
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

    /** Returns the current content of lines or lanes. */
    fun newContent(): GraphContent = GraphContent(lines(), scene, look)

    /** Releases the resources for drawing. */
    fun leave() {
        if (xy?.canvas != null) {
            resizing?.disconnect()
            xy.leave(host)
        }
        if (plot == null) return
        // Keeps the height, so that the page does not move below the reader.
        host.style.height = "${host.clientHeight}px"
        resizing?.disconnect()
        host.textContent = ""
        plot = null
        shown = null
        overlay = null
    }

    /** Draws again with the current colors. */
    fun repaint() {
        if (!isDrawn) return
        leave()
        approach()
        redraw()
    }

    /** Whether part of the drawing is on the screen. */
    val isOnScreen: Boolean
        get() {
            if (!isDrawn) return false
            val box = host.getBoundingClientRect()
            return box.bottom > 0 && box.top < window.innerHeight
        }

    /** Marks the drawing as out of date because the visible range has changed. */
    fun outdate() {
        isStale = isDrawn
    }

    /** Draws the visible range, unless the drawing is up to date. */
    fun refresh() {
        if (!isStale) return
        isStale = false
        isMisplaced = true
        xy?.draw()
        plot?.redraw()
    }

    /** Moves the cursors to their places in a drawing that has changed. */
    fun placeCursors() {
        if (isMisplaced) overlay?.update()
        isMisplaced = false
    }

    /** Moves the cursors to their places. Returns whether lines or lanes are drawn. */
    fun updateCursor(): Boolean {
        xy?.updateCursor()
        overlay?.update()
        return overlay != null
    }

    /** Draws again if the graph is drawn. */
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
