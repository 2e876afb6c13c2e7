package badlog.page.xy

import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.addName
import badlog.page.dom.element
import badlog.page.dom.showText
import badlog.page.input.PointerListener
import badlog.page.pen.PageImage
import badlog.page.view.Scene
import badlog.signals.clock.secondsPerX
import badlog.signals.swerve.swerveModulesOf
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.GraphHeight
import badlog.viewer.choices.board.Plane
import badlog.viewer.draw.color.LINE_COLORS
import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.color.faded
import badlog.viewer.draw.curve.Strokes
import badlog.viewer.draw.figure.LegendEntry
import badlog.viewer.draw.figure.Sheet
import badlog.viewer.draw.path.XyDrawing
import badlog.viewer.draw.path.XyPlot
import badlog.viewer.draw.path.flipIn
import badlog.viewer.draw.path.shown
import badlog.viewer.draw.path.xyPlotOf
import badlog.viewer.draw.pen.Pen
import badlog.viewer.draw.plot.PlotFrame
import badlog.viewer.draw.plot.PlotMargins
import badlog.viewer.input.DragKind
import badlog.viewer.session.Place
import badlog.viewer.session.gesture.XyDrag
import badlog.viewer.session.gesture.XyGestures
import badlog.viewer.session.gesture.XyTarget
import kotlinx.browser.window
import org.w3c.dom.HTMLCanvasElement
import org.w3c.dom.HTMLElement
import org.w3c.dom.HTMLImageElement

/**
 * A graph of the board whose lines are drawn over each other, or as paths on a field.
 *
 * @param look its current settings.
 * @param onToggle called with the lines that a person wants to hide or show.
 * @param onPlane called with the part of the plane that a person has selected, once gestures have ended; null for all of it.
 */
internal class XyGraph(
    private val scene: Scene,
    private val look: () -> BoardGraph,
    private val onToggle: (List<String>) -> Unit,
    private val onPlane: (Plane?) -> Unit,
) {
    /** Its traces, each with its place at the cursor. */
    val legend: HTMLElement = element("div", "legend")

    private val plot: XyPlot? by lazy {
        val flip = look().origin.flipIn(scene.view, scene.field)
        xyPlotOf(look().lines, scene.poses, swerveModulesOf(scene.view.recording.topics), flip, scene.field, scene.view.secondsPerX) {
            scene.board.lines[it]
        }
    }
    private val departure by lazy { plot?.departure(scene.view) }
    private val values = ArrayList<HTMLElement>()
    private val strokes = Strokes()

    /** The picture of the field, once it has been read. */
    private var picture: PageImage? = null
    private val reading by lazy {
        scene.field.image?.let { image ->
            window.document.createElement("img").unsafeCast<HTMLImageElement>().apply {
                onload = {
                    picture = PageImage(this, image.source)
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

    /** The part that the board has stored. */
    private var kept: Plane? = null
    private var timer = 0

    /** The picture; null while it is not drawn. */
    val canvas: HTMLCanvasElement? get() = ground?.canvas

    /** Whether there is anything to draw. */
    val isEmpty: Boolean get() = plot == null

    /** Draws it in [host]. */
    fun start(host: HTMLElement) {
        val plot = plot ?: return
        host.textContent = ""
        host.style.height = "${heightOf(plot, host.clientWidth)}px"
        list()
        ground = XyCanvas(host)
        overlay = XyCanvas(host).also { PointerListener(it.canvas, XyGestures(target), it::box) }
        reading
        draw()
    }

    private fun heightOf(plot: XyPlot, width: Int): Int {
        val most = GraphHeight.LARGE.pixels
        return look().height ?: if (plot.isField) minOf(most, PlotMargins.heightOf(plot.full, width)) else most
    }

    /** Draws it on [sheet] with everything at the cursors. */
    fun drawOn(sheet: Sheet) {
        val plot = plot ?: return
        val high = heightOf(plot, sheet.width)
        sheet.part(high.toDouble()) { pen ->
            val frame = PlotMargins.frameOf(sheet.width, high, scene.range.now, pen.density)
            pen.moved(frame.left, frame.top) {
                drawOn(pen, plot, frame, PenColors.LIGHT)
                drawPlaces(pen, plot, frame, PenColors.LIGHT)
            }
        }
    }

    /** Releases the resources for drawing. */
    fun leave(host: HTMLElement) {
        host.textContent = ""
        ground = null
        overlay = null
    }

    /** Draws what is visible now. */
    fun draw() {
        val canvas = ground ?: return
        val wanted = look().plane?.takeIf { it.isDrawable }
        if (wanted != kept) plane = wanted
        kept = wanted
        canvas.draw { pen -> plot?.let { drawOn(pen, it, canvas.frame, scene.palette.colors) } }
        updateCursor()
    }

    private fun drawOn(pen: Pen, plot: XyPlot, frame: PlotFrame, colors: PenColors) = with(drawing(pen, plot, frame, colors)) {
        ground(picture)
        axes(PlotMargins.LEFT * pen.density)
        traces(shown(plot), scene.range.now, isAll = !scene.range.isZoomed, strokes) { it.color }
        notes(scene.range.now, departure) { it.text(scene.xText(it.time)) }
    }

    private fun drawing(pen: Pen, plot: XyPlot, frame: PlotFrame, colors: PenColors) =
        XyDrawing(pen, plot, seen(frame.width, frame.height), frame.width, frame.height, colors)

    /** Shows everything at its place at the cursor. */
    fun updateCursor() {
        plot?.takeIf { overlay != null }?.let(::showValues)
        drawOverlay()
    }

    private fun drawOverlay() {
        val canvas = overlay ?: return
        val plot = plot ?: return
        canvas.draw {
            target.drag?.let { drag -> it.drawCovered(drag, canvas.frame) }
            drawPlaces(it, plot, canvas.frame, scene.palette.colors)
        }
    }

    private fun Pen.drawCovered(drag: XyDrag, frame: PlotFrame) {
        if (drag.kind == DragKind.PAN) return
        val (start, at) = drag.start to drag.at
        val (wide, high) = (at.shareX - start.shareX) * frame.width to (at.shareY - start.shareY) * frame.height
        val color = faded(scene.palette.colors[Shade.ACCENT], COVER)
        rectangle(start.shareX * frame.width, start.shareY * frame.height, wide, high, color)
    }

    private fun showValues(plot: XyPlot) = plot.traces.asReversed().forEachIndexed { i, trace ->
        values[i].showText(listOfNotNull(scene.cursor.x, scene.cursor.now.second).joinToString(" → ") { trace.textAt(it, plot.isField) })
    }

    private fun drawPlaces(pen: Pen, plot: XyPlot, frame: PlotFrame, colors: PenColors) = with(drawing(pen, plot, frame, colors)) {
        scene.cursor.now.second?.let { marks(it, look().hidden, isSecond = true) { color -> color } }
        marks(scene.cursor.x, look().hidden, isSecond = false) { it }
    }

    private fun shown(plot: XyPlot) = plot.shown(look().hidden)

    private fun seen(width: Double, height: Double): Plane {
        val wanted = plane ?: checkNotNull(plot).full
        return if (plot?.isField == true) wanted.fitted(width, height) else wanted
    }

    private fun show(wanted: Plane?) {
        plane = wanted
        draw()
        window.clearTimeout(timer)
        timer = window.setTimeout({ onPlane(plane) }, REST_MILLISECONDS)
    }

    /** Fills [legend]; the most important trace comes first. */
    fun list() {
        val plot = plot ?: return
        if (legend.childElementCount > 0) return showValues(plot)
        for (trace in plot.traces.asReversed()) {
            legend.addButton("legend-entry", "", "${trace.name} – press to hide or show this line") {
                onToggle(trace.lines)
                mark(plot)
            }.apply {
                add("span", "swatch line-${trace.color % LINE_COLORS}")
                addName(trace.name, "legend-name")
                values += add("span", "value")
            }
        }
        showValues(plot)
        mark(plot)
    }

    private fun mark(plot: XyPlot) {
        val shown = shown(plot)
        plot.traces.asReversed().forEachIndexed { i, trace ->
            legend.children.item(i)?.setAttribute("aria-pressed", (trace in shown).toString())
        }
    }

    /** What the legend says about the drawn traces, with their colors. */
    val entries: List<LegendEntry>
        get() {
            val plot = plot ?: return emptyList()
            val shown = shown(plot)
            return plot.traces.asReversed().withIndex().filter { it.value in shown }.map { (i, trace) ->
                LegendEntry("${trace.name} ${values[i].textContent}".trim(), trace.color)
            }
        }

    private inner class Target : XyTarget {
        override val place: Place get() = scene.place.now
        override val plot: XyPlot? get() = this@XyGraph.plot
        override var plane: Plane?
            get() = this@XyGraph.plane
            set(value) = show(value)
        override var drag: XyDrag? = null
            set(value) {
                field = value
                drawOverlay()
            }

        override fun seen(width: Double, height: Double): Plane = this@XyGraph.seen(width, height)

        override fun go(step: Place.() -> Place) = scene.place.change(step)
    }

    private companion object {
        const val REST_MILLISECONDS = 300
        const val COVER = 0.25
    }
}
