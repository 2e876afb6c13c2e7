package badlog.viewer.draw.swerve

import badlog.core.analysis.PixelColumns
import badlog.core.analysis.Span
import badlog.viewer.draw.axis.AxisSide
import badlog.viewer.draw.axis.limitsFor
import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.curve.Curve
import badlog.viewer.draw.curve.Strokes
import badlog.viewer.draw.pen.Pen
import badlog.viewer.draw.pen.Points
import badlog.viewer.draw.pen.TextSide
import badlog.viewer.draw.plot.AXIS_LETTERS
import badlog.viewer.draw.plot.PlotAxis
import badlog.viewer.draw.plot.PlotFrame
import badlog.viewer.draw.plot.PlotLine
import badlog.viewer.draw.plot.drawCursors
import badlog.viewer.draw.plot.drawGrid
import badlog.viewer.draw.plot.drawLines
import badlog.viewer.draw.plot.drawYNumbers
import badlog.viewer.shown.cursor.Cursors
import badlog.viewer.shown.swerve.DriveErrors
import badlog.viewer.shown.swerve.SwerveDrive
import badlog.viewer.shown.swerve.WheelVector
import kotlin.math.hypot

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

/** The angle errors of all modules over x, each in the module's color. */
internal class ErrorGraph(errors: DriveErrors) {
    private val curves = errors.modules.map { Curve(it.angle, it.angle.range?.endInclusive) }
    private val strokes = curves.map { Strokes() }

    fun draw(pen: Pen, frame: PlotFrame, cursors: Cursors, colors: PenColors) {
        val columns = PixelColumns(frame.width.toInt())
        for (curve in curves) curve.draw(frame.shown.from, frame.shown.to, columns)
        val seen = curves.filter { !it.min.isNaN() }
        val limits = limitsFor(seen.minOfOrNull { it.min } ?: Double.NaN, seen.maxOfOrNull { it.max } ?: Double.NaN, includesZero = true)
        val axes = listOf(PlotAxis(AxisSide.LEFT, "°", limits, color = null))
        val lines = curves.mapIndexed { i, curve ->
            PlotLine(i, strokes[i].apply { trace(curve, frame.x, frame.scaleOf(limits)) }, axis = 0)
        }
        pen.text(TITLE, frame.left, frame.top - ABOVE * pen.density, AXIS_LETTERS * pen.density, colors[Shade.MUTED])
        pen.drawGrid(frame, frame, axes, colors)
        pen.drawLines(frame, lines, axes, isFilled = false, colors)
        pen.drawYNumbers(frame, axes, colors)
        pen.drawCursors(frame, cursors, colors)
    }

    private companion object {
        const val TITLE = "Angle minus its target"
        const val ABOVE = 11.0
    }
}

/**
 * Draws the robot of [drive] from above, its front up, in the middle of [width] by [height]. Each module has an outlined arrow for its
 * target at [time], and a solid one for its measured motion. The arrow of the drive's fastest speed just fits; faster speeds have an arrow
 * of the same length.
 */
internal fun Pen.drawRobot(drive: SwerveDrive, time: Double, width: Double, height: Double, colors: PenColors) {
    val side = minOf(width, height)
    val half = side * HALF
    val middleX = width / 2
    val middleY = height / 2
    val outline = Points().add(middleX - half, middleY - half).add(middleX + half, middleY - half)
        .add(middleX + half, middleY + half).add(middleX - half, middleY + half)
    shapes(outline, corners = 4, colors[Shade.RAISED])
    chain(outline, isClosed = true, colors[Shade.MUTED], LINE * density)
    val letters = AXIS_LETTERS * density
    val top = middleY - half
    val below = top + letters
    val front = Points().add(middleX - letters / 2, below).add(middleX + letters / 2, below).add(middleX, top + letters / 4)
    shapes(front, corners = 3, colors[Shade.MUTED])
    text("front", middleX, below + letters, letters, colors[Shade.MUTED], TextSide.CENTER)
    val longest = side * LONGEST
    val scale = if (drive.fastest > 0) longest / drive.fastest else 0.0
    fun arrowOf(x: Double, y: Double, vector: WheelVector, most: Double) =
        arrow(x, y, -vector.left * scale, -vector.ahead * scale, longest, most)
    drive.modules.forEachIndexed { i, module ->
        val place = module.place
        val x = middleX - place.left * half
        val y = middleY - place.ahead * half
        val color = colors.line(i)
        module.targetAt(time)?.let { arrowOf(x, y, it, TARGET * density) }?.let { chain(it, isClosed = true, color, LINE * density) }
        module.actualAt(time)?.let { arrowOf(x, y, it, ACTUAL * density) }?.let { shapes(it, CORNERS, color) }
        dots(Points().add(x, y), DOT * density, color)
        // Toward the middle, where fewer arrows are.
        val inside = INSIDE * density
        val signX = x + place.left * inside
        val signY = y + place.ahead * inside
        text(module.sign, signX, signY, letters, colors[Shade.TEXT], TextSide.CENTER, isBold = true, halo = colors[Shade.RAISED])
    }
    if (time.isNaN()) text("Point at a graph.", middleX, middleY, letters, colors[Shade.MUTED], TextSide.CENTER)
}

/**
 * Returns the corners of an arrow from ([x], [y]) by [toX] and [toY], at most [longest] long. Its shaft is twice [most] wide, or narrower
 * if the arrow is short. Null if it is too short to draw.
 */
private fun arrow(x: Double, y: Double, toX: Double, toY: Double, longest: Double, most: Double): Points? {
    val whole = hypot(toX, toY)
    if (whole < most) return null
    val length = minOf(whole, longest)
    val half = minOf(most, length / HEAD)
    val alongX = toX / whole
    val alongY = toY / whole
    val head = HEAD * half
    val points = Points()
    fun corner(along: Double, aside: Double) = points.add(x + along * alongX - aside * alongY, y + along * alongY + aside * alongX)
    corner(0.0, half)
    corner(length - head, half)
    corner(length - head, HEAD / 2 * half)
    corner(length, 0.0)
    corner(length - head, -HEAD / 2 * half)
    corner(length - head, -half)
    corner(0.0, -half)
    return points
}

/** Half of the robot's side, as a fraction of the picture's side. */
private const val HALF = 0.23

/** The length of the longest arrow, as a fraction of the picture's side. */
private const val LONGEST = 0.25
private const val CORNERS = 7
private const val LINE = 1.5
private const val TARGET = 4.5
private const val ACTUAL = 2.0
private const val HEAD = 4.5
private const val DOT = 3.5
private const val INSIDE = 15.0
