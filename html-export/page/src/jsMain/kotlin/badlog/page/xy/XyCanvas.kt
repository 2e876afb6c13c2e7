package badlog.page.xy

import badlog.core.analysis.Span
import badlog.page.dom.add
import badlog.page.pen.CanvasPen
import badlog.viewer.draw.pen.Pen
import badlog.viewer.draw.plot.PlotFrame
import badlog.viewer.draw.plot.PlotMargins
import kotlinx.browser.window
import org.w3c.dom.CanvasRenderingContext2D
import org.w3c.dom.DOMRect
import org.w3c.dom.HTMLCanvasElement
import org.w3c.dom.HTMLElement

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
