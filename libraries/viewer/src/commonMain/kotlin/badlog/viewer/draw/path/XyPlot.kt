package badlog.viewer.draw.path

import badlog.core.analysis.GraphSeries
import badlog.core.analysis.LogView
import badlog.core.analysis.Span
import badlog.core.analysis.Units
import badlog.signals.pose.PlannedPath
import badlog.signals.pose.Pose
import badlog.signals.pose.PoseRole
import badlog.signals.pose.Trail
import badlog.signals.pose.planDistance
import badlog.signals.pose.planSpans
import badlog.signals.pose.trailOf
import badlog.signals.swerve.SwerveModules
import badlog.viewer.choices.board.Plane
import badlog.viewer.choices.range.wholeRange
import badlog.viewer.draw.axis.limitsFor
import badlog.viewer.draw.curve.Strokes
import badlog.viewer.shown.cursor.indexAt
import badlog.viewer.text.fixedText
import badlog.viewer.text.numberText
import badlog.viewer.text.shortNames
import kotlin.math.PI
import kotlin.math.atan2
import kotlin.math.cos
import kotlin.math.sin

/**
 * The content of a graph of y over x. It has the paths of poses on a field, otherwise one topic over another.
 *
 * @property traces the traces in drawing order: seen poses first, then planned ones, then the driven path.
 * @property isField whether x and y are places on a field.
 * @property xTitle the title below the graph: name and unit.
 * @property yTitle the title beside the graph.
 * @property field the field, if [isField].
 */
class XyPlot internal constructor(
    internal val traces: List<XyTrace>,
    internal val isField: Boolean,
    internal val xTitle: String,
    internal val yTitle: String,
    private val xUnit: String = "",
    private val yUnit: String = "",
    private val modules: List<ModuleLines> = emptyList(),
    private val flip: FieldFlip? = null,
    val field: Field = Field.PLAIN,
) {
    /** The whole extent. */
    val full: Plane by lazy {
        if (isField) {
            field.around(traces.map { it.trail })
        } else {
            Plane(wholeOf(traces.mapNotNull { it.trail.xSpan }), wholeOf(traces.mapNotNull { it.trail.ySpan }))
        }
    }

    /** The driven path; null if there is none, for example if this is not a field. */
    val driven: XyTrace? get() = if (isField) {
        path?.let {
            traceOf(it.driven)
        } ?: traces.findLast { it.role == PoseRole.DRIVEN }
    } else {
        null
    }

    private val path by lazy { PlannedPath.of(traces.mapNotNull { it.pose }) }

    /** The last result of [lineFit]: a zoom into the plane asks again for the same time. */
    private var fitted: Pair<Span, LineFit?>? = null

    private fun traceOf(pose: Pose) = traces.find { it.pose == pose }

    /**
     * Returns the moment at which the robot of [view] left its plan, according to [planDistance]. The result is null if it never did, or if
     * there is no plan.
     */
    internal fun departure(view: LogView): Departure? = departure(planSpans(view), 1 / (Units.secondsIn(view.xAxis.unit) ?: 1.0))

    /** Returns the departure during [spans], on an x axis on which [second] is one second. */
    internal fun departure(spans: List<Span>, second: Double): Departure? {
        val path = path ?: return null
        val driven = traceOf(path.driven) ?: return null
        val planned = traceOf(path.planned) ?: return null
        return Departure.of(planDistance(driven.trail, planned.trail, spans), second)
    }

    /** Returns the target and measured arrows of the driven robot's modules at [time], targets first. */
    internal fun arrowsAt(time: Double): List<ModuleArrow> {
        val robot = driven ?: return emptyList()
        val index = robot.indexAt(time)
        if (index < 0) return emptyList()
        val heading = robot.headingAt(time).let { if (it.isNaN()) 0.0 else it }
        val x = robot.trail.x[index]
        val y = robot.trail.y[index]
        // A mirror swaps left and right, so the arrows are calculated for the robot as logged, and then mirrored, too.
        val arrows = modules.flatMap {
            if (flip == null) it.arrowsAt(time, x, y, heading) else it.arrowsAt(time, flip.x(x), flip.y(y), flip.heading(heading))
        }
        return arrows.map { if (flip == null) it else it.flipped(flip) }.sortedByDescending { it.isTarget }
    }

    /** Returns the line fitted to the samples of the first trace in [visible]. Null if this is a field, or if no line fits. */
    internal fun lineFit(visible: Span): LineFit? {
        fitted?.let { (span, fit) -> if (span == visible) return fit }
        val fit = if (isField) null else traces.firstOrNull()?.let { LineFit.of(it.trail, visible) }
        fitted = visible to fit
        return fit
    }

    /** Returns the text of [fit], with the units of x and y. */
    internal fun textOf(fit: LineFit): String = fit.text(xUnit, yUnit)

    /**
     * Returns the time when a trace passed nearest to ([x], [y]), at most [reach] pixels away, within [visible]. The result is NaN if none
     * did. If one passed more than once, the result is the time nearest to [before].
     *
     * @param pixelX the length of a pixel along x, and [pixelY] along y: distances are measured on the screen.
     */
    internal fun timeAt(x: Double, y: Double, pixelX: Double, pixelY: Double, reach: Double, visible: Span, before: Double?): Double =
        (driven ?: traces.lastOrNull())?.let { timeOfNearest(it.pyramid, x, y, pixelX, pixelY, reach, visible, before) } ?: Double.NaN

    private fun wholeOf(spans: List<Span>): Span =
        limitsFor(spans.minOfOrNull { it.from } ?: Double.NaN, spans.maxOfOrNull { it.to } ?: Double.NaN, includesZero = false)
}

/**
 * Returns the plot of y over x for a graph that draws [lines], given by name. It has the paths of the [poses] with both x and y among
 * them; without such poses, all other lines over the first one. Null if there is nothing to draw.
 *
 * @param modules the modules of the robot with the driven path.
 * @param flip maps poses onto [field]; null to leave them as logged.
 * @param secondsPerX the length of one unit of x, in s, to recognize resets of the pose: jumps faster than any robot.
 * @param line finds a line by its name.
 */
internal fun xyPlotOf(
    lines: List<String>,
    poses: List<Pose>,
    modules: List<SwerveModules> = emptyList(),
    flip: FieldFlip? = null,
    field: Field = Field.PLAIN,
    secondsPerX: Double = 1.0,
    line: (String) -> GraphSeries?,
): XyPlot? {
    val shown = poses.filter { it.x in lines && it.y in lines }
    if (shown.isEmpty()) return plainPlot(lines.mapNotNull { name -> line(name)?.takeIf { it.states == null } })
    val names = shortNames(shown.map { it.list ?: it.name })
    fun trail(x: GraphSeries, y: GraphSeries, pose: Pose) = trailOf(x.data, y.data, pose.meters).let { flip?.trail(it) ?: it }
        .let { if (pose.role == PoseRole.DRIVEN) it.brokenAtResets(secondsPerX) else it }
    val traces = shown.mapIndexedNotNull { i, pose ->
        val x = line(pose.x) ?: return@mapIndexedNotNull null
        val y = line(pose.y) ?: return@mapIndexedNotNull null
        val followers = if (pose.list == null) emptyList() else poses.filter { it.list == pose.list && it !== pose }
        XyTrace(
            names[i],
            i,
            pose.role,
            trail(x, y, pose),
            listOf(pose.x, pose.y),
            x.wholeRange,
            Heading.of(pose, flip, line),
            followers.mapNotNull { next -> line(next.x)?.let { a -> line(next.y)?.let { b -> trail(a, b, next) } } },
            pose,
        )
    }
    val wheels = modules.mapNotNull { ModuleLines.of(it, line) }
    val ordered = traces.sortedByDescending { it.role }
    return XyPlot(ordered, isField = true, "x (m)", "y (m)", "m", "m", wheels, flip, field).takeIf { traces.isNotEmpty() }
}

/** Returns the menu label for drawing [lines] as a graph of y over x. */
fun xyLabelOf(lines: List<String>, poses: List<Pose>): String =
    if (poses.any { it.x in lines && it.y in lines }) "Path on the field" else "XY plot over the first line"

private fun plainPlot(found: List<GraphSeries>): XyPlot? {
    if (found.size < 2) return null
    val over = found[0]
    val names = shortNames(found.map { it.topic.name })
    val traces = found.drop(1).mapIndexed { i, series ->
        XyTrace(names[i + 1], i, PoseRole.SEEN, trailOf(over.data, series.data), listOf(series.topic.name), over.wholeRange)
    }
    fun title(series: GraphSeries, name: String) = if (Units.isNone(series.unit)) name else "$name (${series.unit})"
    return XyPlot(traces, isField = false, title(over, names[0]), title(found[1], names[1]), over.unit, found[1].unit)
}

/**
 * One of the traces of an [XyPlot].
 *
 * @property name the name in a legend.
 * @property color the index of the color in the palette, from 0.
 * @property role the role of the pose; seen poses are drawn as dots.
 * @property trail the places over time.
 * @property lines the names of the trace's lines, by which a board hides it.
 * @param recorded the whole range of the recording; outside it, nothing has a place.
 * @property followers the places after the first one, for a plan that is an array.
 */
class XyTrace internal constructor(
    val name: String,
    val color: Int,
    val role: PoseRole,
    val trail: Trail,
    val lines: List<String>,
    private val recorded: Span,
    private val heading: Heading? = null,
    val followers: List<Trail> = emptyList(),
    internal val pose: Pose? = null,
) {
    /** Blocks of the samples of [trail]. */
    internal val pyramid: TrailPyramid by lazy { TrailPyramid(trail) }
    private val drawing by lazy { TrailDrawing(pyramid) }

    /** Whether samples are joined by lines. */
    val isJoined: Boolean get() = role != PoseRole.SEEN && followers.isEmpty()

    /**
     * Draws the part of the trace in [span] into [strokes], on [width] by [height] pixels that show [plane]. Draws lines if it [isJoined],
     * otherwise dots. If there are very many dots, each stroke is a row of them, from its left pixel to its right one.
     */
    fun draw(span: Span, plane: Plane, width: Int, height: Int, strokes: Strokes) {
        val x = plane.xScale(width.toDouble())
        val y = plane.yScale(height.toDouble())
        drawing.draw(trail.startOf(span), trail.endOf(span), x, y, width, height, isJoined, strokes)
    }

    /**
     * Returns the index of the sample that a cursor at [time] reads; -1 if the trace has no place then, as before and after the recording.
     */
    fun indexAt(time: Double): Int = indexIn(trail, time)

    private fun indexIn(trail: Trail, time: Double): Int =
        if (time in recorded) trail.indexAt(time).let { if (it >= 0 && trail.isPlace(it)) it else -1 } else -1

    /** Returns the heading at [time] in radians, counterclockwise from x; NaN if unknown. */
    fun headingAt(time: Double): Double = heading?.at(time) ?: Double.NaN

    /**
     * Returns the trace's numbers at [time] for a legend. On a field, these are its place and heading: `3.21, 4.50 m · 87°`. Empty if it
     * has no place.
     */
    fun textAt(time: Double, isField: Boolean): String {
        val index = indexAt(time)
        if (index < 0) return ""
        if (!isField) return "${numberText(trail.x[index])}, ${numberText(trail.y[index])}"
        val place = "${fixedText(trail.x[index], 2)}, ${fixedText(trail.y[index], 2)} m"
        val angle = headingAt(time)
        return if (angle.isNaN()) place else "$place · ${fixedText(angle / PI * HALF_TURN, 0)}°"
    }

    /** Returns the places of an array at [time] in sequence, alternating x and y. */
    fun chainAt(time: Double): DoubleArray {
        val places = (listOf(trail) + followers).map { it to indexIn(it, time) }.filter { (_, index) -> index >= 0 }
        return DoubleArray(places.size * 2) { i -> places[i / 2].let { (one, at) -> if (i % 2 == 0) one.x[at] else one.y[at] } }
    }

    /**
     * Returns the corners of a robot at [time], alternating x and y. The tip at its front is last, unless its heading is unknown. Empty if
     * the robot has no place.
     */
    fun robotAt(time: Double): DoubleArray {
        val index = indexAt(time)
        if (index < 0) return DoubleArray(0)
        val angle = headingAt(time)
        val turn = if (angle.isNaN()) 0.0 else angle
        val shape = if (angle.isNaN()) SQUARE else ARROW
        return DoubleArray(shape.size) { i ->
            val ahead = shape[i / 2 * 2]
            val left = shape[i / 2 * 2 + 1]
            if (i % 2 == 0) trail.x[index] + ahead * cos(turn) - left * sin(turn) else trail.y[index] + ahead * sin(turn) + left * cos(turn)
        }
    }

    private companion object {
        const val HALF_TURN = 180

        /** The outline of a robot with its bumpers, in meters. */
        val SQUARE = doubleArrayOf(-0.42, -0.42, -0.42, 0.42, 0.42, 0.42, 0.42, -0.42)
        val ARROW = doubleArrayOf(0.42, -0.42, -0.42, -0.42, -0.42, 0.42, 0.42, 0.42, 0.75, 0.0)
    }
}

/** The heading of a pose over time. */
internal class Heading private constructor(
    private val parts: List<GraphSeries>,
    private val radians: Double,
    private val flip: FieldFlip?,
) {
    fun at(time: Double): Double = logged(time).let { flip?.heading(it) ?: it }

    private fun logged(time: Double): Double {
        val values = parts.map { line -> line.indexAt(time).let { if (it < 0) return Double.NaN else line.data.y[it] } }
        if (values.size == 1) return values[0] * radians
        val (w, x, y, z) = values
        return atan2(2 * (w * z + x * y), 1 - 2 * (y * y + z * z))
    }

    companion object {
        fun of(pose: Pose, flip: FieldFlip?, line: (String) -> GraphSeries?): Heading? {
            val parts = pose.heading.mapNotNull(line)
            return if (parts.isNotEmpty() && parts.size == pose.heading.size) Heading(parts, pose.radians, flip) else null
        }
    }
}
