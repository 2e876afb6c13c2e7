package badlog.signals.derived

import kotlin.math.sqrt

/**
 * Returns the change of each of [currents], the channels of a power distribution, relative to its equals; 1 if all changed alike. It is the
 * change from the first sixth of enabled time to the last two fifths. Equals are the four drive motors of a swerve drive: at first, they
 * draw similar currents, which rise and fall together. A result is null for other channels, and if the other three changed unlike each
 * other, as they do if wheels work against each other. Returns null if there are no such four, or if a log is too short.
 */
fun channelChanges(times: DoubleArray, currents: List<DoubleArray>, isEnabled: BooleanArray): List<Double?>? {
    val used = times.indices.filter { isEnabled[it] }
    if (used.isEmpty()) return null
    val start = times[used.first()]
    val seconds = times[used.last()] - start
    if (seconds < MIN_SECONDS) return null
    val early = used.filter { times[it] < start + seconds * EARLY }
    val late = used.filter { times[it] > start + seconds * LATE }
    val first = currents.map { meanOf(it, early) }
    val equals = equalsAmong(currents, first, early) ?: return null
    val ratios = equals.associateWith { meanOf(currents[it], late) / first[it] }
    return currents.indices.map { index ->
        val own = ratios[index] ?: return@map null
        val others = ratios.filterKeys { it != index }.values.sorted()
        val spread = others.last() / others.first()
        // The less alike the others are, the more it takes to be unlike them.
        if (spread > MAX_SPREAD) null else own / if (spread > ALIKE_CHANNELS) others.first() else others[others.size / 2]
    }
}

/**
 * Returns the four of [currents] that are alike at the times [at], and like no other one. [means] are the means of all. Null if there are no such
 * four.
 */
private fun equalsAmong(currents: List<DoubleArray>, means: List<Double>, at: List<Int>): Set<Int>? {
    val drawing = currents.indices.filter { means[it] >= MIN_MEAN }
    val alike = drawing.associateWith { one ->
        drawing.filterTo(HashSet()) { other ->
            other == one || correlation(currents[one], means[one], currents[other], means[other], at) > MIN_CORRELATION
        }
    }
    return alike.values.firstOrNull { group ->
        val sizes = group.map { means[it] }
        group.size == EQUALS && group.all { alike[it] == group } && sizes.max() <= MAX_SPREAD * sizes.min()
    }
}

/** Returns Pearson's correlation of [one] and [other], with the given means, at the times [at]; NaN if either is constant. */
private fun correlation(one: DoubleArray, mean: Double, other: DoubleArray, otherMean: Double, at: List<Int>): Double {
    var both = 0.0
    var squares = 0.0
    var otherSquares = 0.0
    for (i in at) {
        val a = orZero(one[i]) - mean
        val b = orZero(other[i]) - otherMean
        both += a * b
        squares += a * a
        otherSquares += b * b
    }
    return both / sqrt(squares * otherSquares)
}

private fun meanOf(current: DoubleArray, at: List<Int>) = at.sumOf { orZero(current[it]) } / at.size

private fun orZero(amperes: Double) = if (amperes.isNaN()) 0.0 else amperes

private const val EQUALS = 4
private const val MIN_SECONDS = 30.0
private const val EARLY = 1.0 / 6
private const val LATE = 0.6

/** In A. */
private const val MIN_MEAN = 1.0
private const val MIN_CORRELATION = 0.5
private const val ALIKE_CHANNELS = 1.3
private const val MAX_SPREAD = 1.5
