package badlog.signals.derived

import kotlin.math.abs

/**
 * Returns the current of each of several equal motors as a share of what the others have on average, 1 for all in a healthy drive: the
 * means of their amounts while the robot is enabled, over the second half of that time, since motors fail in a match. Null if they hardly ran.
 */
fun currentShares(times: DoubleArray, currents: List<DoubleArray>, isEnabled: BooleanArray): DoubleArray? {
    val used = times.indices.filter { i -> isEnabled[i] && currents.all { it[i].isFinite() } }
    if (used.size < LEAST_SAMPLES) return null
    val late = used.drop(used.size / 2)
    val means = currents.map { current -> late.sumOf { abs(current[it]) } / late.size }
    if (means.sum() < LEAST_AMPERES * means.size) return null
    return DoubleArray(means.size) { means[it] / (means.sum() - means[it]) * (means.size - 1) }
}

private const val LEAST_SAMPLES = 500
private const val LEAST_AMPERES = 2.0
