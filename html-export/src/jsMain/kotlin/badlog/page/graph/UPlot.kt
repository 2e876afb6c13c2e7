package badlog.page.graph

import org.w3c.dom.CanvasRenderingContext2D
import org.w3c.dom.HTMLElement

/** The part of uPlot 1.6 that the page uses. It draws frames, axes, lines and areas; the page gives it the paths. */
@JsName("uPlot")
internal external class UPlot(options: dynamic, data: Array<Array<Double?>>, target: HTMLElement) {
    val root: HTMLElement
    val over: HTMLElement
    val ctx: CanvasRenderingContext2D
    val bbox: Box
    val series: Array<dynamic>

    fun batch(work: () -> Unit)
    fun setScale(key: String, limits: dynamic)
    fun setSize(size: dynamic)
    fun setSeries(index: Int, change: dynamic)
    fun destroy()

    /** The frame of the plot on its canvas, in the canvas's pixels. */
    interface Box {
        val left: Double
        val top: Double
        val width: Double
        val height: Double
    }
}
