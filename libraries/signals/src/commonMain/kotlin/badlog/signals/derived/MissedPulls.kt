package badlog.signals.derived

import kotlin.math.floor

/**
 * Returns the number of pulls that each of [currents], the channels of a power distribution, missed. At each time, it is the number of
 * seconds since the channel's last current in which an equal channel pulled. It is 0 unless the channel is without current for 10 s of
 * enabled time or more after a hard pull. An equal is a channel that drew about as much until then, rose and fell at the same moments, and
 * hardly ever pulled alone: the other side of a drive, or another of its wheels. Mechanisms at rest have no equal, since the drive's
 * current shows nothing about them. A result is null for a channel without such a rest.
 *
 * All arrays have the same times.
 *
 * @param pull the current in A that counts as a hard pull.
 */
fun missedPulls(times: DoubleArray, currents: List<DoubleArray>, isEnabled: BooleanArray, pull: Double): List<DoubleArray?> =
    currents.map { own ->
        var missed: DoubleArray? = null
        for (rest in restsOf(times, own, isEnabled)) {
            if (peakBefore(times, own, rest.first) < pull) continue
            // A blocked motor is unlike the others before its breaker opens.
            val end = times[rest.first] - PULL_SECONDS
            val before = (0 until rest.first).filter { times[it] < end && isEnabled[it] && own[it].isFinite() }
            val equals = currents.filter { it !== own && isEqual(own, it, before) }
            if (equals.isEmpty()) continue
            val counts = missed ?: DoubleArray(times.size).also { missed = it }
            for (equal in equals) countPulls(times, equal, rest, counts)
        }
        missed
    }

/** Returns the indices of each long rest of a channel. */
private fun restsOf(times: DoubleArray, own: DoubleArray, isEnabled: BooleanArray): List<IntRange> {
    val rests = ArrayList<IntRange>()
    var start = -1
    for (i in 0..times.size) {
        val isResting = i < times.size && isEnabled[i] && own[i] < NO_AMPERES
        if (isResting && start < 0) start = i
        if (!isResting && start >= 0) {
            if (times[i - 1] - times[start] >= REST_SECONDS) rests += start until i
            start = -1
        }
    }
    return rests
}

private fun peakBefore(times: DoubleArray, own: DoubleArray, at: Int): Double {
    var peak = 0.0
    var i = at - 1
    while (i >= 0 && times[i] >= times[at] - PULL_SECONDS) {
        if (own[i] > peak) peak = own[i]
        i--
    }
    return peak
}

private fun isEqual(own: DoubleArray, other: DoubleArray, before: List<Int>): Boolean {
    if (before.size < MIN_SAMPLES) return false
    val ownMean = before.sumOf { own[it] } / before.size
    val otherMean = before.sumOf { if (other[it].isFinite()) other[it] else 0.0 } / before.size
    if (maxOf(ownMean, otherMean) > MAX_SPREAD * minOf(ownMean, otherMean)) return false
    val pulls = before.filter { other[it] > PULLS_AMPERES }
    if (pulls.size < MIN_PULLS || pulls.count { own[it] > NO_AMPERES } < TOGETHER * pulls.size) return false
    val ownAmperes = DoubleArray(before.size) { own[before[it]] }
    return correlation(ownAmperes, DoubleArray(before.size) { other[before[it]] }) > MIN_CORRELATION
}

/** Raises [counts] in [rest] to the number of seconds until then in which [equal] pulled. */
private fun countPulls(times: DoubleArray, equal: DoubleArray, rest: IntRange, counts: DoubleArray) {
    var second = Double.NaN
    var count = 0
    for (i in rest) {
        if (equal[i] > PULLS_AMPERES && floor(times[i]) != second) {
            second = floor(times[i])
            count++
        }
        if (times[i] - times[rest.first] >= REST_SECONDS) counts[i] = maxOf(counts[i], count.toDouble())
    }
}

private const val NO_AMPERES = 0.5
private const val PULLS_AMPERES = 10.0
private const val REST_SECONDS = 10.0
private const val PULL_SECONDS = 8.0
private const val MIN_SAMPLES = 500
private const val MIN_PULLS = 50
private const val TOGETHER = 0.9
private const val MAX_SPREAD = 2.0
private const val MIN_CORRELATION = 0.5
