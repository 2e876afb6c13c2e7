package badlog.page.graph

import badlog.core.analysis.PixelColumns
import badlog.page.dom.add
import badlog.page.view.Scene
import kotlinx.browser.window
import org.w3c.dom.CanvasRenderingContext2D
import org.w3c.dom.HTMLCanvasElement
import org.w3c.dom.HTMLElement
import kotlin.math.round

/** One graph, [width] CSS pixels wide: a canvas with a frame and axes, and [content] inside, drawn by [redraw]. */
internal class Plot(private val scene: Scene, private val content: PlotContent, host: HTMLElement, private var width: Int) {
    /** The picture. */
    val canvas: HTMLCanvasElement = host.add("canvas").unsafeCast<HTMLCanvasElement>()

    /** The element over the frame, which takes the pointer. */
    val over: HTMLElement = host.add("div", "plot-frame")

    private val context = canvas.getContext("2d").unsafeCast<CanvasRenderingContext2D>()
    private val ratio = window.devicePixelRatio
    private var columns = PixelColumns(1)
    private lateinit var frame: PlotFrame

    /** The width of the frame in CSS pixels. Asking the browser for it would make it lay out the whole page. */
    val frameWidth: Double get() = frame.width / ratio

    /** Its height in CSS pixels. */
    val frameHeight: Double get() = frame.height / ratio

    init {
        fit()
    }

    /** Draws what is visible now. */
    fun redraw() {
        val now = scene.range.now
        frame = frame.showing(now)
        content.prepare(now, columns)
        context.clearRect(0.0, 0.0, canvas.width.toDouble(), canvas.height.toDouble())
        drawPlot(context, frame, scene, content)
    }

    /** Draws at another width. */
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
        frame = plotFrame(width, content.height)
        columns = PixelColumns(frame.width.toInt())
    }

    internal companion object {
        // Every plot has the same margins, which the style sheet knows too, so that the same x is at the same place on the screen in all of
        // them.
        const val GUTTER = 62
        const val RIGHT = 14
        const val TOP = 6
        private const val MIN_WIDTH = 100

        /** The height of the x axis' numbers below the frame, in CSS pixels. */
        const val X_AXIS_HEIGHT = 26

        /** The part of a plot's height above and below its frame. */
        const val MARGINS = TOP + X_AXIS_HEIGHT
    }
}
