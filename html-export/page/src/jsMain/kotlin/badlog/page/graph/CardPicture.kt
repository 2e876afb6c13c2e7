package badlog.page.graph

import badlog.core.analysis.Span
import badlog.page.dom.ResizeObserver
import badlog.page.dom.add
import badlog.page.dom.addName
import badlog.page.dom.isHidden
import badlog.page.dom.showText
import badlog.page.input.PointerListener
import badlog.page.view.Scene
import badlog.page.view.SceneTarget
import badlog.page.xy.XyGraph
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.draw.color.LINE_COLORS
import badlog.viewer.draw.plot.PlotAxis
import badlog.viewer.draw.plot.PlotFrame
import badlog.viewer.input.DragKind
import badlog.viewer.session.gesture.PlotDrag
import badlog.viewer.session.gesture.PlotGestures
import badlog.viewer.text.lengthText
import badlog.viewer.text.word
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

    /** Whether there is a drawing, perhaps an old one; graphs far from the screen have none. */
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

/** The cursors over one plot: their lines, a dot on each curve, and the event and finding under the cursor. */
internal class CursorOverlay(
    colors: List<Int>,
    private val scene: Scene,
    private val content: GraphContent,
    private val plot: PlotCanvas,
) {
    private val line = plot.over.add("div", "cursor-line")
    private val second = plot.over.add("div", "cursor-line is-second")
    private val pointer = plot.over.add("div", "cursor-line is-pointer")
    private val eventLabel = plot.over.add("div", "event-label")
    private val findingLabel = plot.over.add("div", "finding-label")
    private val dots = colors.map { plot.over.add("div", "cursor-dot line-${it % LINE_COLORS}") }

    /** Moves all elements to the current places of the cursors. */
    fun update() {
        val cursors = scene.cursor.now
        val frame = plot.frameOver
        line.classList.toggle("is-pinned", cursors.isPinned)
        line.classList.toggle("is-first", cursors.second != null)
        placeLine(line, cursors.x, frame)
        placeLine(second, cursors.second, frame)
        placeLine(pointer, cursors.hover.takeIf { cursors.isPinned }, frame)
        val x = scene.cursor.x
        dots.forEachIndexed { index, dot ->
            val place = if (x in frame.shown) content.dotAt(index, x, frame) else null
            dot.isHidden = place == null
            place?.let { (left, top) -> dot.style.transform = "translate(${left}px, ${top}px)" }
        }
        label(cursors.pointed ?: Double.NaN, frame)
    }

    private fun placeLine(line: HTMLElement, x: Double?, frame: PlotFrame) {
        val seen = x?.takeIf { it in frame.shown }
        line.isHidden = seen == null
        if (seen != null) line.style.transform = "translateX(${frame.x.placeOf(seen)}px)"
    }

    private fun label(x: Double, frame: PlotFrame) {
        val pointed = if (x in frame.shown) scene.pointedAt(x) else null
        eventLabel.isHidden = pointed?.said == null
        findingLabel.isHidden = pointed?.severity == null
        val pixel = frame.x.placeOf(x)
        pointed?.said?.let { show(eventLabel, it, pixel, frame.width) }
        val severity = pointed?.severity ?: return
        findingLabel.className = "finding-label is-${severity.word}"
        show(findingLabel, pointed.found, pixel, frame.width)
    }

    private fun show(label: HTMLElement, text: String, pixel: Double, width: Double) {
        label.showText(text)
        label.classList.toggle("at-left", pixel > width / 2)
        label.style.transform =
            if (pixel > width / 2) "translateX(calc(${pixel - GAP}px - 100%))" else "translateX(${pixel + GAP}px)"
    }
}

/**
 * The target of gestures over a graph. It shows the range of a drag in [over], which covers the graph's frame.
 *
 * @param onY called with the part of the visible y to show; null for all of it.
 */
internal class GraphTarget(over: HTMLElement, private val scene: Scene, override val lineShare: Double, private val onY: (Span?) -> Unit) :
    SceneTarget(scene) {
    private val selection = over.add("div", "selection").apply { isHidden = true }

    override var drag: PlotDrag? = null
        set(value) {
            field = value
            show(value?.takeIf { it.kind != DragKind.PAN })
        }

    override fun showY(part: Span?) = onY(part)

    private fun show(drag: PlotDrag?) {
        selection.isHidden = drag == null
        if (drag == null) return
        val isY = drag.kind == DragKind.ZOOM_Y
        val now = scene.range.now
        selection.showText(if (isY) "" else "Δ " + lengthText(drag.xSpan.width, scene.xAxis))
        selection.style.left = if (isY) "0" else percent((drag.xSpan.from - now.from) / now.width)
        selection.style.width = if (isY) "100%" else percent(drag.xSpan.width / now.width)
        selection.style.top = if (isY) percent(drag.ySpan.from) else "0"
        selection.style.height = if (isY) percent(drag.ySpan.width) else "100%"
    }

    private fun percent(share: Double) = "${share * 100}%"
}

private const val GAP = 7
