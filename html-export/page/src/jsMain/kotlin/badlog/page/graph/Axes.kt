package badlog.page.graph

import badlog.page.view.Scene
import badlog.viewer.draw.axis.Ticks
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.curve.Scale
import kotlinx.browser.window
import org.w3c.dom.CanvasRenderingContext2D
import kotlin.math.round

/** Draws the x axis and, if [content] has one, the y axis at the left: their lines across [frame], and their numbers beside it. */
internal fun drawAxes(context: CanvasRenderingContext2D, frame: PlotFrame, scene: Scene, content: PlotContent) {
    val ratio = window.devicePixelRatio
    val x = Ticks.ofX(scene.range.now, frame.width / ratio)
    val axis = content.axes.firstOrNull()
    val y = if (axis == null) null else Ticks.ofY(content.limits[0], frame.height / ratio)
    val rows = if (y == null) DoubleArray(0) else placesOf(y, frame.scaleOf(content.limits[0]))

    // A line of one pixel is sharp in the middle of a pixel.
    val middle = ratio % 2 / 2
    context.strokeStyle = scene.palette[Shade.GRID]
    context.lineWidth = ratio
    context.beginPath()
    for (place in placesOf(x, frame.x)) {
        context.moveTo(place + middle, frame.top)
        context.lineTo(place + middle, frame.bottom)
    }
    for (place in rows) {
        context.moveTo(frame.left, place + middle)
        context.lineTo(frame.right, place + middle)
    }
    context.stroke()

    drawXNumbers(context, frame, x, scene)
    if (axis == null || y == null) return
    context.font = axisFont(ratio)
    context.asDynamic().textBaseline = "middle"
    context.asDynamic().textAlign = "right"
    context.fillStyle = if (content.axes.size > 1) axisColor(axis, scene.palette) else scene.palette[Shade.MUTED]
    y.texts.forEachIndexed { i, text -> context.fillText(text, frame.left - GAP * ratio, rows[i]) }
}

private fun placesOf(ticks: Ticks, scale: Scale) = DoubleArray(ticks.values.size) { round(scale.placeOf(ticks.values[it])) }

/** Draws the numbers of the x axis, which are the same below all graphs of a screen: drawing text takes longer than all else. */
private fun drawXNumbers(context: CanvasRenderingContext2D, frame: PlotFrame, ticks: Ticks, scene: Scene) {
    val ratio = window.devicePixelRatio
    val width = context.canvas.width.toDouble()
    val color = scene.palette[Shade.MUTED]
    xNumbers.putOn(context, 0.0, frame.bottom, width, Plot.X_AXIS_HEIGHT * ratio, scene.range.now, color) { picture, _ ->
        val places = placesOf(ticks, frame.x)
        picture.font = axisFont(ratio)
        picture.asDynamic().textBaseline = "top"
        picture.asDynamic().textAlign = "center"
        picture.fillStyle = color
        ticks.texts.forEachIndexed { i, text -> picture.fillText(text, places[i], GAP * ratio) }
    }
}

/** Shared by all plots. Created when the first is drawn, because workers have no canvas. */
private val xNumbers by lazy { KeptPictures() }

/** Returns the font of the numbers of axes, in pixels of a canvas. */
internal fun axisFont(ratio: Double): String = "${AXIS_LETTERS * ratio}px system-ui, -apple-system, \"Segoe UI\", Roboto, sans-serif"

/** The font size of axes, in CSS pixels. */
internal const val AXIS_LETTERS = 11.0

private const val GAP = 6
