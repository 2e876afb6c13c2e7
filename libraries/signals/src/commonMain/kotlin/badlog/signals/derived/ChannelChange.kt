package badlog.signals.derived

/**
 * Returns how the current of each of [currents], the channels of a power distribution, changed from the first sixth of enabled time to the
 * last two fifths, as a share of how those of its equals changed: 1 if all changed alike. Only the four channels that took most at first
 * are equals of each other, the drive motors of a swerve drive; null for others, or if a log is too short.
 */
fun channelChanges(times: DoubleArray, currents: List<DoubleArray>, isEnabled: BooleanArray): List<Double?>? {
    val used = times.indices.filter { isEnabled[it] }
    if (used.isEmpty()) return null
    val start = times[used.first()]
    val seconds = times[used.last()] - start
    if (seconds < LEAST_SECONDS) return null
    val early = used.filter { times[it] < start + seconds * EARLY }
    val late = used.filter { times[it] > start + seconds * LATE }
    fun mean(current: DoubleArray, at: List<Int>) = at.sumOf { current[it].let { a -> if (a.isNaN()) 0.0 else a } } / at.size
    val first = currents.map { mean(it, early) }
    val last = currents.map { mean(it, late) }
    val equals = currents.indices.sortedByDescending { first[it] }.take(EQUALS)
    // Equals are alike, and more than the next.
    if (equals.size < EQUALS || first[equals.last()] < 0.6 * first[equals.first()] || first[equals.last()] < 1) return null
    val rest = currents.indices.filter { it !in equals }.maxOfOrNull { first[it] } ?: 0.0
    if (rest > 0.85 * first[equals.last()]) return null
    val ratios = equals.associateWith { last[it] / first[it] }
    return currents.indices.map { index ->
        val own = ratios[index] ?: return@map null
        val others = ratios.filterKeys { it != index }.values.sorted()
        own / others[others.size / 2]
    }
}

private const val EQUALS = 4
private const val LEAST_SECONDS = 30.0
private const val EARLY = 1.0 / 6
private const val LATE = 0.6
