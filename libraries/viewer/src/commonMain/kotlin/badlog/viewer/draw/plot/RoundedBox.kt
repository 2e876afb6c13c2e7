package badlog.viewer.draw.plot

import badlog.viewer.draw.pen.Points
import kotlin.math.PI
import kotlin.math.cos
import kotlin.math.sin

/** Returns the [ROUNDED_CORNERS] corners of a box that is rounded with [radius], clockwise. */
internal fun roundedBox(left: Double, top: Double, width: Double, height: Double, radius: Double): Points {
    val points = Points()
    for (quarter in 0 until QUARTERS) {
        val centerX = if (quarter == 0 || quarter == QUARTERS - 1) left + width - radius else left + radius
        val centerY = if (quarter < 2) top + height - radius else top + radius
        for (step in 0..STEPS) {
            val angle = (quarter + step.toDouble() / STEPS) * PI / 2
            points.add(centerX + radius * cos(angle), centerY + radius * sin(angle))
        }
    }
    return points
}

private const val QUARTERS = 4

/** The number of steps in a quarter of a circle: more are invisible at a radius of a few pixels. */
private const val STEPS = 4

internal const val ROUNDED_CORNERS: Int = QUARTERS * (STEPS + 1)
