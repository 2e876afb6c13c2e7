package badlog.page.graph

import badlog.core.analysis.PixelColumns
import badlog.page.dom.add
import badlog.page.pen.CanvasPen
import badlog.page.view.Scene
import badlog.viewer.draw.plot.PlotFrame
import badlog.viewer.draw.plot.PlotMargins
import badlog.viewer.draw.plot.drawPlot
import kotlinx.browser.window
import org.w3c.dom.CanvasRenderingContext2D
import org.w3c.dom.HTMLCanvasElement
import org.w3c.dom.HTMLElement
import kotlin.math.round

/** One graph, [width] CSS pixels wide: a canvas with a frame and axes, and [content] inside, drawn by [redraw]. */
internal class PlotCanvas(private val scene: Scene, private val content: GraphContent, host: HTMLElement, private var width: Int) {
    val canvas: HTMLCanvasElement = host.add("canvas").unsafeCast<HTMLCanvasElement>()

    /** The element over the frame that receives the pointer's events. */
    val over: HTMLElement = host.add("div", "plot-frame")

    private val context = canvas.getContext("2d").unsafeCast<CanvasRenderingContext2D>()
    private val ratio = window.devicePixelRatio
    private var columns = PixelColumns(1)
    private lateinit var frame: PlotFrame

    /**
     * The frame in CSS pixels, relative to its own corner. It is calculated, because the browser would lay out the whole page to answer.
     */
    val frameOver: PlotFrame get() = PlotFrame(0.0, 0.0, frame.width / ratio, frame.height / ratio, scene.range.now)

    init {
        fit()
    }

    /** Draws the visible range. */
    fun redraw() {
        frame = frame.showing(scene.range.now)
        val plot = content.plotIn(frame, columns, ratio)
        context.clearRect(0.0, 0.0, canvas.width.toDouble(), canvas.height.toDouble())
        CanvasPen(context).drawPlot(frame, plot, scene.marks, scene.palette.colors, PlotMargins.BOTTOM * ratio)
    }

    /** Draws the graph [newWidth] CSS pixels wide, unless that is too narrow to read. */
    fun resize(newWidth: Int) {
        if (newWidth == width || newWidth < MIN_WIDTH) return
        width = newWidth
        fit()
        redraw()
    }

    private fun fit() {
        canvas.style.width = "${width}px"
        canvas.style.height = "${content.height}px"
        canvas.width = round(width * ratio).toInt()
        canvas.height = round(content.height * ratio).toInt()
        frame = PlotMargins.frameOf(width, content.height, scene.range.now, ratio)
        columns = PixelColumns(frame.width.toInt())
    }
}

private const val MIN_WIDTH = 100
