package badlog.signals.derived

import badlog.core.analysis.Series
import kotlin.math.abs

/**
 * Returns by how much a mechanism's sensor [moved] has drifted from what its motor's position [turned] says since the robot was first
 * enabled, in percent of the mechanism's range: 0 while one ratio holds for both. [times] are those of all arrays. Empty if the motor
 * hardly moved, or if the two were never coupled. Before, code may set either position.
 */
fun couplingError(times: DoubleArray, turned: DoubleArray, moved: DoubleArray, isEnabled: BooleanArray): Series {
    val range = quantile(moved, 0.98) - quantile(moved, 0.02)
    val first = isEnabled.indexOfFirst { it }
    val ratio = if (first < 0) null else ratioOf(turned, moved, first)
    if (ratio == null || !(range > 0)) return Series(DoubleArray(0), DoubleArray(0))
    val rest = DoubleArray(times.size) { moved[it] - ratio * turned[it] }
    val until = times.indices.firstOrNull { times[it] > times[first] + START_SECONDS } ?: times.size
    val start = quantile(rest.copyOfRange(first, until), 0.5)
    return Series(times, DoubleArray(times.size) { if (it < first) 0.0 else 100 * (rest[it] - start) / range })
}

/**
 * Returns whether [moved] stands exactly still at [times] although [turned] has moved by more than a twentieth of its range since it last
 * changed while the robot is enabled: 1 or 0.
 */
fun frozenWhileTurning(times: DoubleArray, turned: DoubleArray, moved: DoubleArray, isEnabled: BooleanArray): Series {
    val range = quantile(turned, 0.98) - quantile(turned, 0.02)
    var low = Double.NaN
    var high = Double.NaN
    return Series(
        times,
        DoubleArray(times.size) { i ->
            if (i == 0 || moved[i] != moved[i - 1] || low.isNaN()) {
                low = turned[i]
                high = turned[i]
            }
            if (turned[i] < low) low = turned[i]
            if (turned[i] > high) high = turned[i]
            if (isEnabled[i] && range > 0 && high - low > FROZEN_SHARE * range) 1.0 else 0.0
        },
    )
}

/**
 * Returns the median of how far the mechanism moves for each turn of the motor, over its first steps: what breaks later does not count.
 * Null if there are too few.
 */
private fun ratioOf(turned: DoubleArray, moved: DoubleArray, first: Int): Double? {
    val range = quantile(moved, 0.98) - quantile(moved, 0.02)
    if (!(range > 0)) return null
    val ratios = ArrayList<Double>()
    var last = first
    for (i in first until turned.size) {
        if (turned[last].isNaN() || moved[last].isNaN()) last = i
        val step = moved[i] - moved[last]
        if (abs(step) < STEP_SHARE * range) continue
        if (turned[i] != turned[last]) ratios += step / (turned[i] - turned[last])
        last = i
        if (ratios.size == FIRST_STEPS) break
    }
    if (ratios.size < LEAST_STEPS) return null
    return quantile(ratios.toDoubleArray(), 0.5).takeIf { it != 0.0 && it.isFinite() }
}

private const val START_SECONDS = 8.0
private const val FROZEN_SHARE = 0.05
private const val STEP_SHARE = 0.05
private const val FIRST_STEPS = 60
private const val LEAST_STEPS = 15
