package badlog.page.xy

import badlog.core.analysis.Span
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.addName
import badlog.page.dom.element
import badlog.page.dom.showText
import badlog.page.input.PointerListener
import badlog.page.pen.CanvasPen
import badlog.page.pen.PageImage
import badlog.page.view.Scene
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.GraphHeight
import badlog.viewer.choices.board.Plane
import badlog.viewer.draw.color.LINE_COLORS
import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.color.faded
import badlog.viewer.draw.figure.LegendEntry
import badlog.viewer.draw.figure.Sheet
import badlog.viewer.draw.path.LogPaths
import badlog.viewer.draw.path.XyFrame
import badlog.viewer.draw.path.XyLog
import badlog.viewer.draw.path.XyPicture
import badlog.viewer.draw.pen.Pen
import badlog.viewer.draw.plot.PlotFrame
import badlog.viewer.draw.plot.PlotMargins
import badlog.viewer.input.DragKind
import badlog.viewer.session.gesture.XyDrag
import badlog.viewer.session.gesture.XyGestures
import badlog.viewer.session.gesture.XyTarget
import badlog.viewer.state.Action
import badlog.viewer.state.Place
import kotlinx.browser.window
import org.w3c.dom.CanvasRenderingContext2D
import org.w3c.dom.DOMRect
import org.w3c.dom.HTMLCanvasElement
import org.w3c.dom.HTMLElement
import org.w3c.dom.HTMLImageElement

/**
 * A graph of the board that draws one line over another, or paths on a field.
 *
 * @param look returns the graph's current settings.
 * @param onToggle called with the lines to hide or show.
 * @param onPlane called with the selected part of the plane once gestures have ended; null for all of it.
 */
internal class XyGraph(
    private val scene: Scene,
    private val look: () -> BoardGraph,
    private val onToggle: (List<String>) -> Unit,
    private val onPlane: (Plane?) -> Unit,
) {
    /** The graph's traces, each with its place at the cursor. */
    val legend: HTMLElement = element("div", "legend")

    private var picture = lazy(::newPicture)
    private val entries get() = picture.value.parts.flatMap { it.entries }
    private val values = ArrayList<HTMLElement>()

    /** The picture of the field, once it has been loaded. */
    private var field: PageImage? = null
    private val reading by lazy {
        scene.field.image?.let { image ->
            window.document.createElement("img").unsafeCast<HTMLImageElement>().apply {
                onload = {
                    field = PageImage(this, image.source)
                    draw()
                }
                src = image.source
            }
        }
    }
    private var ground: XyCanvas? = null
    private var overlay: XyCanvas? = null

    private val target = Target()

    /** The visible part of the plane; null for all of it. */
    private var plane: Plane? = null

    /** The part of the plane that the board has stored. */
    private var kept: Plane? = null
    private var timer = 0

    /** The canvas of the traces; null while the graph is not drawn. */
    val canvas: HTMLCanvasElement? get() = ground?.canvas

    val isEmpty: Boolean get() = picture.value.isEmpty

    /** Shows the currently compared logs at the next drawing. */
    fun renew() {
        val isListed = legend.childElementCount > 0
        picture = lazy(::newPicture)
        legend.textContent = ""
        values.clear()
        if (isListed) list()
    }

    private fun newPicture(): XyPicture {
        val others = scene.compared.map { log -> XyLog(LogPaths(log.lines.view, scene.field) { log.lines[it] }, log.name, log.offset) }
        return XyPicture(look().lines, look().origin, listOf(XyLog(scene.paths, scene.openName)) + others)
    }

    /** Draws the graph in [host]. */
    fun start(host: HTMLElement) {
        host.textContent = ""
        host.style.height = "${heightAt(host.clientWidth)}px"
        list()
        ground = XyCanvas(host)
        overlay = XyCanvas(host).also { PointerListener(it.canvas, XyGestures(target), it::box) }
        reading
        draw()
    }

    private fun heightAt(width: Int): Int {
        val most = GraphHeight.LARGE.pixels
        val field = picture.value.full.takeIf { picture.value.isField }
        return look().height ?: if (field == null) most else minOf(most, PlotMargins.heightOf(field, width))
    }

    /** Draws the graph on [sheet] with the places at the cursors. */
    fun drawOn(sheet: Sheet) {
        val high = heightAt(sheet.width)
        sheet.part(high.toDouble()) { pen ->
            val frame = PlotMargins.frameOf(sheet.width, high, scene.range.now, pen.density)
            pen.moved(frame.left, frame.top) {
                drawOn(pen, frame, PenColors.LIGHT)
                drawPlaces(pen, frame, PenColors.LIGHT)
            }
        }
    }

    /** Releases the resources for drawing. */
    fun leave(host: HTMLElement) {
        host.textContent = ""
        ground = null
        overlay = null
    }

    /** Draws the visible range. */
    fun draw() {
        val canvas = ground ?: return
        val wanted = look().plane?.takeIf { it.isDrawable }
        if (wanted != kept) plane = wanted
        kept = wanted
        canvas.draw { pen -> drawOn(pen, canvas.frame, scene.palette.colors) }
        updateCursor()
    }

    private fun drawOn(pen: Pen, frame: PlotFrame, colors: PenColors) {
        val seen = seenIn(frame, pen, colors) ?: return
        picture.value.draw(seen, look().hidden, scene.range.now, field, axesFrom = PlotMargins.LEFT * pen.density)
    }

    private fun seenIn(frame: PlotFrame, pen: Pen, colors: PenColors) =
        target.seen(frame.width, frame.height)?.let { XyFrame(pen, it, frame.width, frame.height, colors) }

    /** Updates the values and places at the cursor. */
    fun updateCursor() {
        if (overlay != null) showValues()
        drawOverlay()
    }

    private fun drawOverlay() {
        val canvas = overlay ?: return
        canvas.draw {
            target.drag?.let { drag -> it.drawCovered(drag, canvas.frame) }
            drawPlaces(it, canvas.frame, scene.palette.colors)
        }
    }

    private fun Pen.drawCovered(drag: XyDrag, frame: PlotFrame) {
        if (drag.kind == DragKind.PAN) return
        val (start, at) = drag.start to drag.at
        val (wide, high) = (at.shareX - start.shareX) * frame.width to (at.shareY - start.shareY) * frame.height
        val color = faded(scene.palette.colors[Shade.ACCENT], COVER)
        rectangle(start.shareX * frame.width, start.shareY * frame.height, wide, high, color)
    }

    private fun showValues() = entries.forEachIndexed { i, entry -> values[i].showText(entry.textAt(scene.cursor.now)) }

    private fun drawPlaces(pen: Pen, frame: PlotFrame, colors: PenColors) {
        seenIn(frame, pen, colors)?.let { picture.value.drawCursors(it, look().hidden, scene.cursor.now) }
    }

    private fun show(wanted: Plane?) {
        plane = wanted
        draw()
        window.clearTimeout(timer)
        timer = window.setTimeout({ onPlane(plane) }, REST_MILLISECONDS)
    }

    /** Fills [legend], the most important trace first. */
    private fun list() {
        if (legend.childElementCount > 0) return showValues()
        for (entry in entries) {
            legend.addButton("legend-entry", "", "${entry.title} – press to hide or show this line") {
                onToggle(entry.lines)
                mark()
            }.apply {
                add("span", "swatch line-${entry.color % LINE_COLORS}")
                addName(entry.title, "legend-name")
                values += add("span", "value")
            }
        }
        showValues()
        mark()
    }

    private fun mark() = entries.forEachIndexed { i, entry ->
        legend.children.item(i)?.setAttribute("aria-pressed", entry.isShown(look().hidden).toString())
    }

    /** The legend of the drawn traces in a figure. */
    val legendOnSheet: List<LegendEntry> get() = picture.value.legend(look().hidden, scene.cursor.now)

    private inner class Target : XyTarget {
        override val place: Place get() = scene.store.place
        override val picture: XyPicture get() = this@XyGraph.picture.value
        override var plane: Plane?
            get() = this@XyGraph.plane
            set(value) = show(value)
        override var drag: XyDrag? = null
            set(value) {
                field = value
                drawOverlay()
            }

        override fun send(action: Action) = scene.store.send(action)
    }
}

/** A canvas that covers [host], with a frame in it. */
internal class XyCanvas(host: HTMLElement) {
    val canvas: HTMLCanvasElement = host.add("canvas", "xy").unsafeCast<HTMLCanvasElement>()
    private val context = canvas.getContext("2d").unsafeCast<CanvasRenderingContext2D>()

    init {
        canvas.width = (host.clientWidth * pixelRatio).toInt()
        canvas.height = (host.clientHeight * pixelRatio).toInt()
    }

    /** The frame of the canvas; its x axis is not the log's. */
    val frame: PlotFrame = PlotMargins.frameOf(host.clientWidth, host.clientHeight, Span(0.0, 1.0), pixelRatio)

    /** The position of the frame in the window. */
    val box: DOMRect
        get() = canvas.getBoundingClientRect().run {
            DOMRect(left + PlotMargins.LEFT, top + PlotMargins.TOP, frame.width / pixelRatio, frame.height / pixelRatio)
        }

    /** Clears the canvas and calls [draw] with the origin at the frame's corner. */
    fun draw(draw: (Pen) -> Unit) {
        context.clearRect(0.0, 0.0, canvas.width.toDouble(), canvas.height.toDouble())
        val pen = CanvasPen(context)
        pen.moved(frame.left, frame.top) { draw(pen) }
    }
}

/** The number of physical pixels in one CSS pixel. */
internal val pixelRatio: Double get() = window.devicePixelRatio

private const val REST_MILLISECONDS = 300
private const val COVER = 0.25
