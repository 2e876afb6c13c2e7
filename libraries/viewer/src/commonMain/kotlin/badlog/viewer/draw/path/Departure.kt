package badlog.viewer.draw.path

import badlog.core.analysis.Series
import badlog.core.analysis.Span
import badlog.signals.pose.PLAN_LIMIT
import badlog.signals.pose.PLAN_PATIENCE
import badlog.signals.pose.Trail
import badlog.viewer.text.fixedText
import kotlin.math.hypot

/**
 * The moment at which a robot left its planned path.
 *
 * @property time the time.
 * @property index the index of the driven path's sample at that time.
 * @property farthest the largest distance from the plan before the robot came back or the plan ended, in meters.
 */
internal class Departure(val time: Double, val index: Int, val farthest: Double) {
    /** Returns a sentence about the departure; [moment] is the text of its time. */
    fun text(moment: String): String = "Left the plan at $moment, by up to ${fixedText(farthest, 2)} m"

    companion object {
        /**
         * Returns the first moment in [distances] from which the robot was more than [PLAN_LIMIT] away for [PLAN_PATIENCE]. Null if there
         * is none.
         *
         * @param second one second in the unit of the x axis.
         */
        fun of(distances: Series, second: Double): Departure? {
            var since = -1
            var farthest = 0.0
            for (i in 0..distances.size) {
                val distance = if (i < distances.size) distances.y[i] else Double.NaN
                if (distance > PLAN_LIMIT) {
                    if (since < 0) since = i
                    farthest = maxOf(farthest, distance)
                } else if (since >= 0) {
                    val end = distances.x[minOf(i, distances.size - 1)]
                    if (end - distances.x[since] >= PLAN_PATIENCE * second) return Departure(distances.x[since], since, farthest)
                    since = -1
                    farthest = 0.0
                }
            }
            return null
        }
    }
}

/**
 * Returns this path of a robot with gaps at resets of its pose, instead of jumps across the field. A gap is a sample without a place, at
 * the time of the first place after it. Without a reset, the path itself is returned.
 *
 * @param secondsPerX the length of one unit of x, in s.
 */
internal fun Trail.brokenAtResets(secondsPerX: Double): Trail {
    val resets = (1 until size).filter { isReset(it, secondsPerX) }
    if (resets.isEmpty()) return this
    val from = IntArray(size + resets.size)
    var next = 0
    for (i in 0 until size) {
        if (next < resets.size && resets[next] == i) from[i + next++] = GAP
        from[i + next] = i
    }
    fun broken(values: DoubleArray) = DoubleArray(from.size) { if (from[it] == GAP) Double.NaN else values[from[it]] }
    return Trail(DoubleArray(from.size) { times[if (from[it] == GAP) from[it + 1] else from[it]] }, broken(x), broken(y))
}

/** Returns the places before and after each gap of this path in [visible], alternating x and y. */
internal fun Trail.resetsIn(visible: Span): DoubleArray {
    val places = ArrayList<Double>()
    for (i in maxOf(1, startOf(visible)) until minOf(size - 1, endOf(visible))) {
        if (isPlace(i) || times[i] != times[i + 1] || !isPlace(i - 1) || !isPlace(i + 1)) continue
        places += listOf(x[i - 1], y[i - 1], x[i + 1], y[i + 1])
    }
    return places.toDoubleArray()
}

private fun Trail.isReset(index: Int, secondsPerX: Double): Boolean {
    if (!isPlace(index) || !isPlace(index - 1)) return false
    val seconds = (times[index] - times[index - 1]) * secondsPerX
    return hypot(x[index] - x[index - 1], y[index] - y[index - 1]) > MAX_CORRECTED + FASTEST * maxOf(0.0, seconds)
}

private const val GAP = -1

/** A speed in m/s that no robot reaches. */
private const val FASTEST = 8.0

/** A distance in m that is larger than corrections of a pose by cameras. */
private const val MAX_CORRECTED = 0.75
