package badlog.signals.derived

import badlog.core.analysis.Series
import kotlin.math.sqrt

/**
 * Returns how far from the robot's place just before the camera's places are, in m, at the time of each of them.
 *
 * @param seen x and y of what the camera saw; a new picture has a new time in either.
 * @param driven x and y of where the robot believed to be.
 */
fun sightError(seen: Pair<Series, Series>, driven: Pair<Series, Series>): Series {
    val times = timesOf(listOf(seen.first, seen.second))
    val x = seen.first.heldAt(times)
    val y = seen.second.heldAt(times)
    // What is seen moves the estimate at once, so that from just before counts.
    val before = DoubleArray(times.size) { times[it] - BEFORE_SECONDS }
    val ownX = driven.first.heldAt(before)
    val ownY = driven.second.heldAt(before)
    return Series(times, DoubleArray(times.size) { i -> sqrt((x[i] - ownX[i]).let { it * it } + (y[i] - ownY[i]).let { it * it }) })
}

private const val BEFORE_SECONDS = 0.005
