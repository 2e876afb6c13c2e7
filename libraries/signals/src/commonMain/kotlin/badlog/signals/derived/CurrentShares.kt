package badlog.signals.derived

import kotlin.math.abs

/**
 * Returns the current of each of several equal motors as a share of the others' average. It is 1 in a healthy drive. Absolute currents
 * count while the robot is enabled, over the second half of that time, since motors fail in a match. Returns null if they hardly ran. The
 * result of a motor is null if the others are not alike: wheels then work against each other, as they do if one of them points aside.
 */
fun currentShares(times: DoubleArray, currents: List<DoubleArray>, isEnabled: BooleanArray): List<Double?>? {
    val used = times.indices.filter { i -> isEnabled[i] && currents.all { it[i].isFinite() } }
    if (used.size < MIN_SAMPLES) return null
    val late = used.drop(used.size / 2)
    val means = currents.map { current -> late.sumOf { abs(current[it]) } / late.size }
    if (means.sum() < MIN_AMPERES * means.size) return null
    return means.mapIndexed { at, own ->
        val others = means.filterIndexed { index, _ -> index != at }
        if (others.max() > ALIKE * others.min()) null else own / others.average()
    }
}

/** Returns the largest of [currents] at each time; an unknown one counts as 0. */
internal fun largestOf(currents: List<DoubleArray>): DoubleArray =
    DoubleArray(currents[0].size) { i -> currents.maxOf { if (it[i].isFinite()) it[i] else 0.0 } }

private const val ALIKE = 1.2
private const val MIN_SAMPLES = 500
private const val MIN_AMPERES = 2.0
