package badlog.viewer.draw.swerve

import badlog.core.analysis.Span
import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.pen.Pen
import badlog.viewer.draw.plot.PlotFrame
import badlog.viewer.shown.cursor.Cursors
import badlog.viewer.shown.swerve.DriveErrors
import badlog.viewer.shown.swerve.SwerveDrive

/**
 * The picture of a [drive]: the robot from above with the arrows of its modules. Below it are [errors] over the visible range. It caches
 * everything that depends only on the log.
 *
 * @param errors the drive's errors; null to draw the robot alone.
 */
class DrivePicture(private val drive: SwerveDrive, errors: DriveErrors?) {
    private val graph = errors?.let(::ErrorGraph)

    /** The height of the picture, in CSS pixels or dp. */
    val height: Int = if (graph == null) ROBOT else ROBOT + GRAPH

    /** Draws the picture with [pen], [width] physical pixels wide: the robot at [cursors], and the errors in [visible]. */
    fun draw(pen: Pen, width: Double, visible: Span, cursors: Cursors, colors: PenColors) {
        pen.drawRobot(drive, cursors.x ?: Double.NaN, width, ROBOT * pen.density, colors)
        val left = LEFT * pen.density
        val right = width - RIGHT * pen.density
        val top = (ROBOT + ABOVE) * pen.density
        val frame = PlotFrame(left, top, right - left, (GRAPH - ABOVE - BELOW) * pen.density, visible)
        if (frame.width >= 1) graph?.draw(pen, frame, cursors, colors)
    }

    private companion object {
        const val ROBOT = 230
        const val GRAPH = 130
        const val LEFT = 46.0
        const val RIGHT = 12.0
        const val ABOVE = 20.0
        const val BELOW = 8.0
    }
}
