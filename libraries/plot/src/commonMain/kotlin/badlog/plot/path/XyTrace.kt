package badlog.plot.path

import badlog.analysis.GraphSeries
import badlog.analysis.Span
import badlog.plot.cursor.indexAt
import badlog.plot.curve.Strokes
import badlog.plot.text.fixedText
import badlog.rules.path.Pose
import badlog.rules.path.PoseRole
import badlog.rules.path.Trail
import kotlin.math.PI
import kotlin.math.atan2
import kotlin.math.cos
import kotlin.math.sin

/**
 * One of the traces of an [XyPlot].
 *
 * @property name what a legend calls it.
 * @property color which of the palette's colors it has, from 0.
 * @property role what it is; what was seen is drawn as dots.
 * @property trail where it was.
 * @property lines the names of the lines that it is made of, by which a board hides it.
 * @property followers of a plan that is an array, where the places after the first one were.
 */
public class XyTrace internal constructor(
    public val name: String,
    public val color: Int,
    public val role: PoseRole,
    public val trail: Trail,
    public val lines: List<String>,
    private val heading: Heading? = null,
    public val followers: List<Trail> = emptyList(),
    internal val pose: Pose? = null,
) {
    private val drawing = TrailDrawing()

    /** Whether its samples are joined by lines. */
    public val isJoined: Boolean get() = role != PoseRole.SEEN && followers.isEmpty()

    /** Draws what of it lies in [span] into [strokes], on [width] by [height] pixels that show [plane]. */
    public fun draw(span: Span, plane: Plane, width: Int, height: Int, strokes: Strokes) {
        val x = plane.xScale(width.toDouble())
        val y = plane.yScale(height.toDouble())
        drawing.draw(trail, trail.startOf(span), trail.endOf(span), x, y, width, height, isJoined, strokes)
    }

    /** The sample that a cursor at [time] reads; -1 where it is nowhere then. */
    public fun indexAt(time: Double): Int = trail.indexAt(time).let { if (it >= 0 && trail.isPlace(it)) it else -1 }

    /** The heading at [time] in radians, counterclockwise from x; NaN where it is not known. */
    public fun headingAt(time: Double): Double = heading?.at(time) ?: Double.NaN

    /** Where it is at [time] and where it heads, as a legend says it: `3.21, 4.50 m · 87°`; empty for nowhere. */
    public fun textAt(time: Double, isField: Boolean): String {
        val index = indexAt(time)
        if (index < 0) return ""
        val place = "${fixedText(trail.x[index], 2)}, ${fixedText(trail.y[index], 2)}"
        val angle = headingAt(time)
        val degrees = angle / PI * HALF_TURN
        return if (!isField) {
            place
        } else if (angle.isNaN()) {
            "$place m"
        } else {
            "$place m · ${fixedText(degrees, 0)}°"
        }
    }

    /** Of an array: the places one after the other at [time], x and y in turn. */
    public fun chainAt(time: Double): DoubleArray {
        val places = (listOf(trail) + followers).mapNotNull { one ->
            one.indexAt(time).takeIf { it >= 0 && one.isPlace(it) }?.let {
                one to
                    it
            }
        }
        return DoubleArray(places.size * 2) { i -> places[i / 2].let { (one, at) -> if (i % 2 == 0) one.x[at] else one.y[at] } }
    }

    /** The corners of a robot at [time], x and y in turn, its bow last but where its heading is not known; empty where it is nowhere. */
    public fun robotAt(time: Double): DoubleArray {
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

        /** A robot with its bumpers, in meters. */
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
