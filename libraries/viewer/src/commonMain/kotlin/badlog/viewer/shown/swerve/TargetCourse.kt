package badlog.viewer.shown.swerve

import badlog.core.analysis.Series
import badlog.core.analysis.Span

/** How the target of a module turns, where errors count. It is filled moment by moment, at [x]. */
internal class TargetCourse(private val x: DoubleArray) {
    private val time = DoubleArray(x.size)
    private val places = Series(x, time)
    private val turned = DoubleArray(x.size)
    private val net = DoubleArray(x.size)
    private var size = 0
    private var didCount = false

    /** Adds the next moment, from which on errors count if [counts], and in which the target has turned by [degrees]; NaN if unknown. */
    fun add(counts: Boolean, degrees: Double) {
        val i = size++
        if (i > 0) {
            val step = if (counts && didCount && !degrees.isNaN()) degrees else 0.0
            time[i] = time[i - 1] + if (didCount) x[i] - x[i - 1] else 0.0
            turned[i] = turned[i - 1] + if (step < 0) -step else step
            net[i] = net[i - 1] + step
        }
        didCount = counts
    }

    /** Returns the part of it within [part]. */
    fun within(part: Span): Turning {
        val first = places.firstAfter(part.from) - 1
        val last = places.firstAfter(part.to) - 1
        fun between(sum: DoubleArray) = if (last < 0) 0.0 else sum[last] - sum[maxOf(0, first)]
        return Turning(between(time) + since(last, part.to) - since(first, part.from), between(turned), between(net))
    }

    /** Returns how much of the time from the moment [i] to [to] counts. */
    private fun since(i: Int, to: Double): Double = if (i >= 0 && i + 1 < x.size && time[i + 1] > time[i]) to - x[i] else 0.0
}

/**
 * How a target turns over a part of x.
 *
 * @property time how long errors count in it, in s; more than 0 if they count at all.
 * @property turned by how much it turns in both directions together, in degrees.
 * @property net by how much it turns in the end, in degrees.
 */
internal class Turning(val time: Double, val turned: Double, val net: Double)
