package badlog.page.graph

import badlog.page.dom.json
import badlog.plot.curve.Curve
import org.w3c.dom.Path2D
import kotlin.math.PI

/** [curve] on the canvas, as uPlot takes it: the line, and the area between it and 0 when it [isFilled]. */
internal fun curvePath(curve: Curve, frame: PlotFrame, isFilled: Boolean): dynamic {
    val line = Path2D()
    val area = if (isFilled) Path2D() else null
    val baseline = frame.baseline
    var startX = Double.NaN
    var lastX = 0.0
    var lastY = 0.0
    var count = 0

    fun endRun() {
        // A sample between two gaps would be a line of no length, which nobody sees.
        if (count == 1) {
            line.moveTo(lastX - 1, lastY)
            line.lineTo(lastX + 1, lastY)
        }
        if (count > 1 && area != null) {
            area.lineTo(lastX, baseline)
            area.lineTo(startX, baseline)
            area.closePath()
        }
        count = 0
    }

    for (i in 0 until curve.size) {
        val value = curve.y[i]
        if (value.isNaN()) {
            endRun()
            continue
        }
        lastX = frame.pixelOfX(curve.x[i])
        lastY = frame.pixelOfY(value).coerceIn(-FARTHEST, FARTHEST)
        if (count++ == 0) {
            startX = lastX
            line.moveTo(lastX, lastY)
            area?.moveTo(lastX, lastY)
        } else {
            line.lineTo(lastX, lastY)
            area?.lineTo(lastX, lastY)
        }
    }
    endRun()
    return json("stroke" to line, "fill" to area, "clip" to null, "flags" to 0)
}

/** A dot for each point of [curve], as uPlot takes it. */
internal fun dotsPath(curve: Curve, frame: PlotFrame, radius: Double): dynamic {
    val dots = Path2D()
    for (i in 0 until curve.size) {
        val x = frame.pixelOfX(curve.x[i])
        if (curve.isCorner(i) || curve.y[i].isNaN() || x < frame.left - radius || x > frame.right + radius) continue
        val y = frame.pixelOfY(curve.y[i])
        dots.moveTo(x + radius, y)
        dots.arc(x, y, radius, 0.0, 2 * PI)
    }
    return json("stroke" to null, "fill" to dots, "clip" to null, "flags" to 0)
}

/** So many pixels away, everything is out of sight, and the graphics library still counts exactly. */
private const val FARTHEST = 1e6
