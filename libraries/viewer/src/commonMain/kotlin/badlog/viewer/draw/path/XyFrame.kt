package badlog.viewer.draw.path

import badlog.signals.pose.PoseRole
import badlog.viewer.choices.board.Plane
import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.curve.Scale
import badlog.viewer.draw.pen.Pen

/**
 * The frame in which a graph of y over x is drawn. Its top left corner is the pen's origin.
 *
 * @property seen the visible part of the plane.
 * @property width the width in physical pixels.
 * @property height the height in physical pixels.
 */
class XyFrame(
    internal val pen: Pen,
    internal val seen: Plane,
    internal val width: Double,
    internal val height: Double,
    internal val colors: PenColors,
)

/** Returns the scale of this plane's x on [width] pixels. */
fun Plane.xScale(width: Double): Scale = Scale(x.from, x.to, width, farthest = FARTHEST * width)

/** Returns the scale of this plane's y on [height] pixels. */
fun Plane.yScale(height: Double): Scale = Scale.ofY(y, height)

/** The same limit as for y: coordinates far outside the screen would be too large for drawing. */
private const val FARTHEST = 50.0

/**
 * One element that an [XyPlot] shows at a moment.
 *
 * @property places the points to join by lines, alternating x and y; a single one is a dot.
 * @property color the index of the color in the palette, like [XyTrace.color]; null for the arrow of a module.
 * @property isClosed whether the last place is joined with the first, as for the outline of a robot.
 * @property isFilled whether the area is filled, as for the robot itself, but not its planned place.
 * @property isTarget whether an arrow shows a target rather than a measured value.
 */
internal class XyMark(
    val places: DoubleArray,
    val color: Int?,
    val isClosed: Boolean = false,
    val isFilled: Boolean = false,
    val isTarget: Boolean = false,
) {
    /** Whether this is a single place. */
    val isDot: Boolean get() = places.size == 2
}

/** Returns the traces that have no line in [hidden]. */
internal fun XyPlot.shown(hidden: Set<String>): List<XyTrace> = traces.filter { trace -> trace.lines.none { it in hidden } }

/**
 * Returns the marks of everything that is not [hidden] at [time], in drawing order. Robots are outlines with a dot at their center, other
 * places are dots, and a plan in an array is a line; the arrows of the driven robot's modules follow.
 */
internal fun XyPlot.marksAt(time: Double, hidden: Set<String>): List<XyMark> = shown(hidden).flatMap { trace ->
    val index = trace.indexAt(time)
    when {
        trace.followers.isNotEmpty() -> listOfNotNull(XyMark(trace.chainAt(time), trace.color).takeIf { it.places.size > 2 })

        index < 0 -> emptyList()

        else -> listOfNotNull(
            XyMark(trace.robotAt(time), trace.color, isClosed = true, isFilled = trace.role == PoseRole.DRIVEN)
                .takeIf { isField && trace.role != PoseRole.SEEN },
            XyMark(doubleArrayOf(trace.trail.x[index], trace.trail.y[index]), trace.color),
        )
    }
} + arrowsAt(time).map { XyMark(it.places, color = null, isTarget = it.isTarget) }
