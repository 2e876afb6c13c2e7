package badlog.page.graph

import badlog.analysis.PixelColumns
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

    /** How wide the frame is, in CSS pixels. The browser would lay the whole page out to say it. */
    val frameWidth: Double get() = frame.width / ratio

    /** How high it is. */
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
        // Every plot has the same margins, which the style sheet knows too, so that one place on x is one place on the screen in all of them.
        const val GUTTER = 62
        const val RIGHT = 14
        const val TOP = 6
        private const val MIN_WIDTH = 100

        /** How much room the numbers of x have below the frame, in CSS pixels. */
        const val X_AXIS_HEIGHT = 26

        /** How much of a plot's height is above and below its frame. */
        const val MARGINS = TOP + X_AXIS_HEIGHT
    }
}
