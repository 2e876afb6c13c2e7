package badlog.signals.derived

import badlog.core.analysis.Series
import kotlin.math.abs
import kotlin.math.round

/**
 * Returns how fast the gyro's heading [gyro] turns away from the heading [seen] by a camera, in degrees per second; both are in degrees. It is the
 * slope over the last [SPAN_SECONDS] or longer, in which the two have to move apart steadily: a heading that is set anew jumps. Single
 * pictures are often wrong, so the median of several seconds counts. Empty unless the two turn alike: a gyro may count the other way, or in
 * another unit.
 */
fun headingGap(gyro: Series, seen: Series): Series {
    val times = ArrayList<Double>()
    val gaps = ArrayList<Double>()
    val own = gyro.heldAt(seen.x)
    if (!turnsAlike(own, seen)) return Series(DoubleArray(0), DoubleArray(0))
    var from = 0
    while (from < seen.size) {
        var until = from
        val pictures = ArrayList<Double>()
        val near = gaps.lastOrNull() ?: (own[from] - seen.y[from])
        while (until < seen.size && seen.x[until] < seen.x[from] + STEP_SECONDS) {
            // The same picture may be logged again.
            val isNew = until == 0 || seen.y[until] != seen.y[until - 1]
            val gap = own[until] - seen.y[until] - near
            if (isNew && gap.isFinite()) pictures += near + gap - FULL_TURN * round(gap / FULL_TURN)
            until++
        }
        if (pictures.size >= MIN_PICTURES) {
            times += seen.x[from]
            gaps += pictures.sorted()[pictures.size / 2]
        }
        from = until
    }
    return Series(times.toDoubleArray(), DoubleArray(times.size) { steadyRate(times, gaps, it) })
}

/** Returns whether [own] turns as [seen] does, each time that it clearly turns within [STEP_SECONDS]. */
private fun turnsAlike(own: DoubleArray, seen: Series): Boolean {
    fun turn(degrees: DoubleArray, from: Int, to: Int) = (degrees[to] - degrees[from]).let { it - FULL_TURN * round(it / FULL_TURN) }
    var alike = 0
    var unlike = 0
    var last = 0
    for (i in 1 until seen.size) {
        val sight = turn(seen.y, last, i)
        val gyro = turn(own, last, i)
        val isKnown = (gyro - sight).isFinite() && seen.x[i] - seen.x[last] <= STEP_SECONDS
        if (isKnown && abs(sight) !in CLEAR_TURN) continue
        if (isKnown && abs(gyro - sight) < abs(sight) / 2) {
            alike++
        } else if (isKnown) {
            unlike++
        }
        last = i
    }
    return alike >= MIN_ALIKE && alike > MOSTLY * unlike
}

/** Returns the slope of [gaps] over the last [SPAN_SECONDS] before [at], without its sign; 0 unless they are close to a line and go far. */
private fun steadyRate(times: List<Double>, gaps: List<Double>, at: Int): Double {
    val first = (at downTo 0).firstOrNull { times[at] - times[it] >= SPAN_SECONDS } ?: return 0.0
    val seconds = times[at] - times[first]
    val whole = gaps[at] - gaps[first]
    if (at - first < MIN_STEPS || seconds > LONGEST_SECONDS || abs(whole) < MIN_DEGREES) return 0.0
    val isLine = (first..at).all { abs(gaps[it] - gaps[first] - whole * (times[it] - times[first]) / seconds) < STRAIGHT * abs(whole) }
    return if (isLine) abs(whole) / seconds else 0.0
}

private const val FULL_TURN = 360.0
private const val STEP_SECONDS = 4.0
private const val MIN_PICTURES = 8
private const val SPAN_SECONDS = 20.0
private const val LONGEST_SECONDS = 40.0

/** In degrees. Half a turn has no direction. */
private val CLEAR_TURN = 20.0..120.0
private const val MIN_ALIKE = 3
private const val MOSTLY = 4
private const val MIN_STEPS = 5
private const val MIN_DEGREES = 8.0
private const val STRAIGHT = 0.15
