package badlog.plot.path

import badlog.rules.path.PoseRole

/**
 * One thing that an [XyPlot] shows of a moment.
 *
 * @property places what is joined by lines, x and y in turn; a single place is a dot.
 * @property color which of the palette's colors it has, as [XyTrace.color]; null for the arrow of a module.
 * @property isClosed whether the last place is joined with the first: the outline of a robot.
 * @property isFilled whether it is filled, too: the robot itself, not where it should be.
 * @property isTarget of an arrow, whether it is what was wanted, not what was done.
 */
public class XyMark internal constructor(
    public val places: DoubleArray,
    public val color: Int?,
    public val isClosed: Boolean = false,
    public val isFilled: Boolean = false,
    public val isTarget: Boolean = false,
) {
    /** Whether it is a single place. */
    public val isDot: Boolean get() = places.size == 2
}

/** The traces of this of which no line is among [hidden]. */
public fun XyPlot.shown(hidden: Set<String>): List<XyTrace> = traces.filter { trace -> trace.lines.none { it in hidden } }

/**
 * Where everything but what is [hidden] is at [time], in the order in which it is drawn: robots as outlines with a dot in their middle, other
 * places as dots, what an array plans as a line, then the arrows of the driven robot's modules.
 */
public fun XyPlot.marksAt(time: Double, hidden: Set<String>): List<XyMark> = shown(hidden).flatMap { trace ->
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
