package badlog.expression.samples

import badlog.core.analysis.Units
import kotlin.math.abs
import kotlin.math.round

/**
 * Returns, for each sample, the smallest finite value in the window of [width] that ends at it. Returns the largest values instead if
 * [isLargest]. A value from before the window counts if it still holds when the window begins. The result is a gap if the window has no
 * value.
 *
 * A fixed sample splits the window into an older and a newer part. The extremes of the older part are known for every start; the extreme of
 * the newer part is updated with each sample. When the start passes the split, the split moves to the newest sample. So each sample is
 * visited twice, however wide the window is.
 */
internal fun Column.windowExtreme(width: Double, isLargest: Boolean): Column {
    val older = DoubleArray(size)
    val results = DoubleArray(size)
    var meeting = -1
    var begin = 0
    var newer = Double.NaN
    for (i in 0 until size) {
        begin = firstWithin(begin, i, width)
        if (begin > meeting) {
            var best = Double.NaN
            for (j in i downTo begin) {
                best = better(best, y[j], isLargest)
                older[j] = best
            }
            meeting = i
            newer = Double.NaN
        } else {
            newer = better(newer, y[i], isLargest)
        }
        results[i] = better(older[begin], newer, isLargest)
    }
    return with(results)
}

/** Returns the larger of two, or the smaller; if one is not finite, the other. */
private fun better(known: Double, other: Double, isLargest: Boolean): Double =
    if (other - other != 0.0 || (if (isLargest) other <= known else other >= known)) known else other

/**
 * Returns, for each sample, the mean over the window of [width] that ends at it, weighted by time. Gaps, and the time before the first
 * sample, do not count. If no time is left, it is the sample's own value. No value is ever subtracted from a sum, which would leave its
 * rounding error behind, see [windowExtreme].
 */
internal fun Column.windowMean(width: Double): Column {
    val olderSums = DoubleArray(size)
    val olderWeights = DoubleArray(size)
    val results = DoubleArray(size)
    var meeting = -1
    var begin = 0
    var newer = 0.0
    var newerWeight = 0.0

    // The first index since which the value has been the same.
    var sameFrom = 0

    // The time for which sample j is known, and that time multiplied by its value. A sample holds until the next.
    fun weight(j: Int) = if (y[j].isFinite()) x[j + 1] - x[j] else 0.0
    fun area(j: Int) = if (y[j].isFinite()) y[j] * (x[j + 1] - x[j]) else 0.0
    for (i in 0 until size) {
        begin = firstWithin(begin, i, width)
        // The first one counts only for the part within the window. Those after it, up to the previous one, count fully.
        if (begin + 1 > meeting) {
            var sum = 0.0
            var weight = 0.0
            for (j in i - 1 downTo begin + 1) {
                sum += area(j)
                weight += weight(j)
                olderSums[j] = sum
                olderWeights[j] = weight
            }
            if (i > 0) meeting = i - 1
            newer = 0.0
            newerWeight = 0.0
        } else {
            newer += area(i - 1)
            newerWeight += weight(i - 1)
        }
        var sum = newer
        var weight = newerWeight
        if (begin + 1 <= minOf(meeting, i - 1)) {
            sum += olderSums[begin + 1]
            weight += olderWeights[begin + 1]
        }
        if (begin < i && y[begin].isFinite()) {
            val part = x[begin + 1] - maxOf(x[begin], x[i] - width)
            sum += y[begin] * part
            weight += part
        }
        if (i > 1 && y[i - 1] != y[i - 2]) sameFrom = i - 1
        results[i] = if (weight > 0) {
            // A constant value is its own mean, regardless of rounding in the sum.
            if (sameFrom <= begin) y[begin] else sum / weight
        } else if (y[i].isFinite()) {
            y[i]
        } else {
            Double.NaN
        }
    }
    return with(results)
}

/** Returns the last sample at or before [width] before sample [index]. It still holds into the window. Never before [from]. */
private fun Column.firstWithin(from: Int, index: Int, width: Double): Int {
    val begin = x[index] - width + slack(width, x[index])
    var first = from
    while (first < index && x[first + 1] <= begin) first++
    return first
}

/** Returns the length of a second on an x axis in [unit]; 1 if that is not a unit of time. */
internal fun perSecond(unit: String): Double {
    val seconds = Units.secondsIn(unit) ?: 1.0
    return if (seconds < 1) round(1 / seconds) else 1 / seconds
}

/**
 * Returns the amount by which a span of [length] up to [time] may appear too long. Times in a file are rounded to decimals, and 0.5 after
 * 9.52 must be 10.02, despite binary fractions.
 */
internal fun slack(length: Double, time: Double): Double = length * 1e-9 + abs(time) * 1e-15
