package badlog.viewer.shown.swerve

import badlog.core.analysis.Series
import badlog.core.analysis.Span

/** The turning of a module's target, where errors count. It is filled moment by moment, at [x]; a [second] is in the unit of x. */
internal class TargetCourse(private val x: DoubleArray, private val second: Double) {
    private val time = DoubleArray(x.size)
    private val places = Series(x, time)
    private val turned = DoubleArray(x.size)
    private val net = DoubleArray(x.size)
    private var size = 0
    private var wasCounting = false

    /** Adds the next moment, at which the target has turned by [degrees]; NaN if unknown. Errors count from then on if [counts]. */
    fun add(counts: Boolean, degrees: Double) {
        val i = size++
        if (i > 0) {
            val step = if (counts && wasCounting && !degrees.isNaN()) degrees else 0.0
            time[i] = time[i - 1] + if (wasCounting) x[i] - x[i - 1] else 0.0
            turned[i] = turned[i - 1] + if (step < 0) -step else step
            net[i] = net[i - 1] + step
        }
        wasCounting = counts
    }

    /** Returns the turning within [part]. */
    fun within(part: Span): Turning {
        val first = places.firstAfter(part.from) - 1
        val last = places.firstAfter(part.to) - 1
        fun between(sum: DoubleArray) = if (last < 0) 0.0 else sum[last] - sum[maxOf(0, first)]
        val counted = between(time) + since(last, part.to) - since(first, part.from)
        return Turning(counted / second, between(turned), between(net))
    }

    /** Returns the time from the moment [i] to [to] in which errors count. */
    private fun since(i: Int, to: Double): Double = if (i >= 0 && i + 1 < x.size && time[i + 1] > time[i]) to - x[i] else 0.0
}

/**
 * The turning of a target over a part of x.
 *
 * @property time the time in which errors count, in s; more than 0 if they count at all.
 * @property turned the turning in both directions together, in degrees.
 * @property net the net turning, in degrees: opposite directions cancel out.
 */
internal class Turning(val time: Double, val turned: Double, val net: Double)
