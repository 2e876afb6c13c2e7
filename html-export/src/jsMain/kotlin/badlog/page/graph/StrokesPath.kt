package badlog.page.graph

import badlog.page.dom.json
import badlog.plot.curve.Strokes
import org.w3c.dom.Path2D
import kotlin.math.PI

/** [strokes] on the canvas, as uPlot takes them: the lines, and the area between them and [baseline] where there is one. */
internal fun strokesPath(strokes: Strokes, baseline: Double?): dynamic {
    val line = Path2D()
    val area = if (baseline != null) Path2D() else null
    val points = strokes.points
    for (i in 0 until strokes.count) {
        var at = strokes.startOf(i)
        val end = strokes.endOf(i)
        // One that stands alone is a dot.
        if (end - at == 2) continue
        area?.moveTo(points[at], baseline ?: 0.0)
        area?.lineTo(points[at], points[at + 1])
        line.moveTo(points[at], points[at + 1])
        at += 2
        while (at < end) {
            line.lineTo(points[at], points[at + 1])
            area?.lineTo(points[at], points[at + 1])
            at += 2
        }
        area?.lineTo(points[end - 2], baseline ?: 0.0)
        area?.closePath()
    }
    return json("stroke" to line, "fill" to area, "clip" to null, "flags" to 0)
}

/** The dots of [strokes], as uPlot takes them. */
internal fun dotsPath(strokes: Strokes, frame: PlotFrame, radius: Double): dynamic {
    val path = Path2D()
    val dots = strokes.dots
    var at = 0
    while (at < strokes.dotsSize) {
        val x = dots[at]
        if (x >= frame.left - radius && x <= frame.right + radius) {
            path.moveTo(x + radius, dots[at + 1])
            path.arc(x, dots[at + 1], radius, 0.0, 2 * PI)
        }
        at += 2
    }
    return json("stroke" to null, "fill" to path, "clip" to null, "flags" to 0)
}
