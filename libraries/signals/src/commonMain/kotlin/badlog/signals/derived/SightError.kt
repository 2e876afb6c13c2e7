package badlog.signals.derived

import badlog.core.analysis.Series
import kotlin.math.abs
import kotlin.math.hypot

/**
 * Returns the distance of each place that the camera saw from the robot's own estimate just before, in m, at the times of these places. The
 * error is smaller if the place before or after is off in the same way: the robot's estimate was then wrong, as it is after its wheels
 * slipped.
 *
 * @param seen x and y of the places that the camera saw; a new picture has a new time in either.
 * @param driven x and y of the robot's own estimate.
 */
fun sightError(seen: Pair<Series, Series>, driven: Pair<Series, Series>): Series {
    val times = timesOf(listOf(seen.first, seen.second))
    val x = seen.first.heldAt(times)
    val y = seen.second.heldAt(times)
    // A seen place moves the estimate at once, so the estimate from just before counts.
    val before = DoubleArray(times.size) { times[it] - BEFORE_SECONDS }
    val ownX = driven.first.heldAt(before)
    val ownY = driven.second.heldAt(before)
    val offX = DoubleArray(times.size) { x[it] - ownX[it] }
    val offY = DoubleArray(times.size) { y[it] - ownY[it] }
    fun unlike(at: Int, step: Int): Double {
        var other = at
        // The same picture may be logged again, and nothing between pictures.
        while (other in times.indices && (x[other].isNaN() || (x[other] == x[at] && y[other] == y[at]))) other += step
        val isNear = other in times.indices && abs(times[other] - times[at]) < NEAR_SECONDS
        return if (isNear) hypot(offX[at] - offX[other], offY[at] - offY[other]) else Double.POSITIVE_INFINITY
    }
    return Series(
        times,
        DoubleArray(times.size) { i -> if (x[i].isNaN()) Double.NaN else minOf(hypot(offX[i], offY[i]), unlike(i, -1), unlike(i, 1)) },
    )
}

private const val BEFORE_SECONDS = 0.005
private const val NEAR_SECONDS = 0.5
