package badlog.page.graph

import badlog.viewer.draw.curve.Strokes
import org.w3c.dom.CanvasRenderingContext2D
import kotlin.math.PI

/** Draws the lines of [strokes] with the pen of [context]. */
internal fun drawLines(context: CanvasRenderingContext2D, strokes: Strokes) {
    context.beginPath()
    addPaths(context, strokes) { _, _ -> }
    context.stroke()
}

/** Fills what is between the lines of [strokes] and [baseline]. */
internal fun drawAreas(context: CanvasRenderingContext2D, strokes: Strokes, baseline: Double) {
    context.beginPath()
    addPaths(context, strokes) { from, to ->
        context.lineTo(to, baseline)
        context.lineTo(from, baseline)
        context.closePath()
    }
    context.fill()
}

/** Adds each stroke to the path, and calls [end] with where it began and ended on x. */
private inline fun addPaths(context: CanvasRenderingContext2D, strokes: Strokes, end: (Double, Double) -> Unit) {
    val points = strokes.points
    for (i in 0 until strokes.count) {
        val start = strokes.startOf(i)
        val size = strokes.endOf(i)
        // An isolated sample is a dot.
        if (size - start == 2) continue
        context.moveTo(points[start], points[start + 1])
        for (at in start + 2 until size step 2) context.lineTo(points[at], points[at + 1])
        end(points[start], points[size - 2])
    }
}

/** Fills the dots of [strokes] that are in [frame]. */
internal fun drawDots(context: CanvasRenderingContext2D, strokes: Strokes, frame: PlotFrame, radius: Double) {
    if (strokes.dotsSize == 0) return
    val dots = strokes.dots
    context.beginPath()
    for (at in 0 until strokes.dotsSize step 2) {
        val x = dots[at]
        val y = dots[at + 1]
        if (x < frame.left - radius || x > frame.right + radius || y < frame.top - radius || y > frame.bottom + radius) continue
        context.moveTo(x + radius, y)
        context.arc(x, y, radius, 0.0, 2 * PI)
    }
    context.fill()
}
