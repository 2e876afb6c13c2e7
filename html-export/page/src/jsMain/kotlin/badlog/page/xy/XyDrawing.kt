package badlog.page.xy

import badlog.core.analysis.Span
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.element
import badlog.page.dom.showText
import badlog.page.export.Sheet
import badlog.page.view.Scene
import badlog.signals.pose.PoseRole
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.GraphHeight
import badlog.viewer.draw.color.LINE_COLORS
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.curve.Strokes
import badlog.viewer.draw.path.Plane
import badlog.viewer.draw.path.XyPlot
import badlog.viewer.draw.path.XyTrace
import badlog.viewer.draw.path.marksAt
import badlog.viewer.draw.path.shown
import badlog.viewer.draw.path.swerveModulesOf
import badlog.viewer.draw.path.xyPlotOf
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
internal class XyDrawing(
    private val scene: Scene,
    private val look: () -> BoardGraph,
    private val onToggle: (List<String>) -> Unit,
    private val onPlane: (Plane?) -> Unit,
) {
    /** Its traces, each with its place at the cursor. */
    val legend: HTMLElement = element("div", "legend")

    private val plot: XyPlot? by lazy {
        val flip = look().origin.flipIn(scene.view, scene.field)
        xyPlotOf(look().lines, scene.poses, swerveModulesOf(scene.view.recording.topics), flip, scene.field) { scene.board.lines[it] }
    }
    private val departure by lazy { plot?.departure(scene.view) }
    private val values = ArrayList<HTMLElement>()
    private val strokes = Strokes()
    private val ground by lazy {
        scene.field.image?.let { image ->
            window.document.createElement("img").unsafeCast<HTMLImageElement>().apply {
                onload = { draw() }
                src = image.source
            }
        }
    }
    private var picture: XyCanvas? = null
    private var overlay: XyCanvas? = null

    /** The visible part of the plane; null for all of it. */
    private var plane: Plane? = null

    /** The part that the board has stored. */
    private var kept: Plane? = null
    private var timer = 0

    /** The picture; null while it is not drawn. */
    val canvas: HTMLCanvasElement? get() = picture?.canvas

    /** Whether there is anything to draw. */
    val isEmpty: Boolean get() = plot == null

    /** Draws it in [host]. */
    fun start(host: HTMLElement) {
        val plot = plot ?: return
        host.textContent = ""
        host.style.height = "${heightOf(plot, host.clientWidth)}px"
        list()
        picture = XyCanvas.over(host)
        overlay = XyCanvas.over(host).also { XyGestures(it, scene, plot, ::seen) { wanted -> show(wanted) } }
        draw()
    }

    private fun heightOf(plot: XyPlot, width: Int): Int {
        val most = GraphHeight.LARGE.pixels
        return look().height ?: if (plot.isField) minOf(most, XyCanvas.heightOf(plot.full, width)) else most
    }

    /** Draws it on [sheet] with everything at the cursors. */
    fun drawOn(sheet: Sheet) {
        val plot = plot ?: return
        val high = heightOf(plot, sheet.width)
        sheet.part(high) {
            val canvas = XyCanvas(sheet.context, sheet.width * sheet.ratio, high * sheet.ratio)
            drawOn(canvas, plot)
            drawPlaces(canvas, plot)
        }
    }

    /** Releases the resources for drawing. */
    fun leave(host: HTMLElement) {
        host.textContent = ""
        picture = null
        overlay = null
    }

    /** Draws what is visible now. */
    fun draw() {
        val canvas = picture ?: return
        val wanted = look().plane?.takeIf { it.isDrawable }
        if (wanted != kept) plane = wanted
        kept = wanted
        canvas.clear()
        drawOn(canvas, plot ?: return)
        updateCursor()
    }

    private fun drawOn(canvas: XyCanvas, plot: XyPlot) {
        val seen = seen(canvas)
        canvas.drawGround(seen, plot, ground, scene.palette)
        val visible = scene.range.now
        val all = Span(Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY)
        for (trace in shown(plot)) {
            if (trace.followers.isNotEmpty()) continue
            if (scene.range.isZoomed && plot.isField) drawTrace(canvas, trace, all, seen, FAINT)
            drawTrace(canvas, trace, visible, seen, 1.0)
        }
        canvas.drawNotes(seen, plot, departure, scene)
    }

    /** Shows everything at its place at the cursor. */
    fun updateCursor() {
        val canvas = overlay ?: return
        val plot = plot ?: return
        canvas.clear()
        showValues(plot)
        drawPlaces(canvas, plot)
    }

    private fun showValues(plot: XyPlot) = plot.traces.asReversed().forEachIndexed { i, trace ->
        values[i].showText(listOfNotNull(scene.cursor.x, scene.cursor.now.second).joinToString(" → ") { trace.textAt(it, plot.isField) })
    }

    private fun drawPlaces(canvas: XyCanvas, plot: XyPlot) {
        scene.cursor.now.second?.let { drawPlaces(canvas, plot, it, isSecond = true) }
        drawPlaces(canvas, plot, scene.cursor.x, isSecond = false)
    }

    /** Draws everything at its place at [time]; for the second cursor, as rings. */
    private fun drawPlaces(canvas: XyCanvas, plot: XyPlot, time: Double, isSecond: Boolean) {
        val seen = seen(canvas)
        for (mark in plot.marksAt(time, look().hidden)) {
            val color = mark.color?.let(scene.palette::line) ?: scene.palette[if (mark.isTarget) Shade.MUTED else Shade.ACCENT]
            canvas.color(color, if (mark.isTarget) TARGET else 1.0)
            if (mark.isDot) {
                canvas.dot(mark.places[0], mark.places[1], seen, SECOND.takeIf { isSecond })
            } else {
                canvas.chain(mark.places, seen, mark.isClosed, mark.isFilled && !isSecond)
            }
        }
    }

    private fun shown(plot: XyPlot) = plot.shown(look().hidden)

    private fun drawTrace(canvas: XyCanvas, trace: XyTrace, span: Span, seen: Plane, opacity: Double) {
        trace.draw(span, seen, canvas.width.toInt(), canvas.height.toInt(), strokes)
        canvas.color(scene.palette.line(trace.color), opacity)
        canvas.trace(strokes, trace.isJoined, isDashed = trace.role == PoseRole.PLANNED)
    }

    private fun seen(canvas: XyCanvas): Plane {
        val wanted = plane ?: checkNotNull(plot).full
        return if (plot?.isField == true) wanted.fitted(canvas.width, canvas.height) else wanted
    }

    private fun show(wanted: Plane?) {
        if (wanted?.isDrawable == false) return
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
                add("bdi", "legend-name", trace.name)
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

    private companion object {
        const val FAINT = 0.25
        const val SECOND = 5.0
        const val REST_MILLISECONDS = 300
        const val TARGET = 0.8
    }
}

/** The number of physical pixels in one CSS pixel. */
internal val pixelRatio: Double get() = window.devicePixelRatio
