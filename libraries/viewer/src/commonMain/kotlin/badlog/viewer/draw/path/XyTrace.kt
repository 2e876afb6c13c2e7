package badlog.viewer.draw.path

import badlog.core.analysis.GraphSeries
import badlog.core.analysis.Span
import badlog.signals.pose.Pose
import badlog.signals.pose.PoseRole
import badlog.signals.pose.Trail
import badlog.viewer.choices.board.Plane
import badlog.viewer.draw.curve.Strokes
import badlog.viewer.shown.cursor.indexAt
import badlog.viewer.text.fixedText
import badlog.viewer.text.numberText
import kotlin.math.PI
import kotlin.math.atan2
import kotlin.math.cos
import kotlin.math.sin

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
