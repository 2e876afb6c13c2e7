package badlog.expression.samples

import badlog.analysis.Units
import kotlin.math.abs
import kotlin.math.round

/** What is made of the values in a window. */
internal enum class Folding { MIN, MAX, MEAN }

/**
 * For each sample what [folding] makes of the finite values later than [width] before it, up to its own; a gap without any.
 *
 * Two halves meet at a fixed sample: of the older one the results up to there are known for every begin, the newer one grows.
 * When the begin passes the meeting point, it moves to the newest sample. So no value is ever taken out of a sum, which would
 * leave its rounding behind, and each sample is seen twice however wide the window is.
 */
internal fun Column.windowed(width: Double, folding: Folding): Column {
    val older = DoubleArray(size)
    val olderCounts = IntArray(size)
    val results = DoubleArray(size)
    var meeting = -1
    var begin = 0
    var newer = 0.0
    var newerCount = 0
    for (i in 0 until size) {
        val from = x[i] - width + slack(width, x[i])
        while (x[begin] <= from && begin < i) begin++
        if (begin > meeting) {
            var sum = 0.0
            var count = 0
            for (j in i downTo begin) {
                sum = folding.add(sum, count, y[j])
                if (y[j].isFinite()) count++
                older[j] = sum
                olderCounts[j] = count
            }
            meeting = i
            newer = 0.0
            newerCount = 0
        } else {
            newer = folding.add(newer, newerCount, y[i])
            if (y[i].isFinite()) newerCount++
        }
        val count = olderCounts[begin] + newerCount
        val sum = if (newerCount == 0) older[begin] else folding.merge(older[begin], olderCounts[begin], newer)
        results[i] = if (count == 0) {
            Double.NaN
        } else if (folding == Folding.MEAN) {
            sum / count
        } else {
            sum
        }
    }
    return with(results)
}

private fun Folding.add(sum: Double, count: Int, value: Double) = if (value.isFinite()) merge(sum, count, value) else sum

private fun Folding.merge(sum: Double, count: Int, other: Double): Double = when {
    count == 0 -> other
    this == Folding.MIN -> minOf(sum, other)
    this == Folding.MAX -> maxOf(sum, other)
    else -> sum + other
}

/** How much of x a second is, where x is a time in [unit]; 1 where it has none. */
internal fun perSecond(unit: String): Double {
    val seconds = Units.secondsIn(unit) ?: 1.0
    return if (seconds < 1) round(1 / seconds) else 1 / seconds
}

/**
 * How much a stretch of [length] up to [time] may seem longer than it is: times are rounded to decimals in a file, and 0.5 after
 * 9.52 is 10.02, whatever binary fractions make of it.
 */
internal fun slack(length: Double, time: Double): Double = length * 1e-9 + abs(time) * 1e-15
