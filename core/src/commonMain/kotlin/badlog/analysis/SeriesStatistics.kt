package badlog.analysis

import kotlin.math.sqrt

/**
 * What a series does over a range of x. Every figure but the counts is NaN when there is no value in the range.
 *
 * @property count how many samples of the range have a finite value.
 * @property gaps how many have none.
 * @property mean the arithmetic mean of the samples, not weighted by time.
 * @property standardDeviation of a sample, dividing by `count - 1`; NaN for fewer than two values.
 * @property percentile5 the value below which 5 % lie, interpolated linearly between neighbours (type 7 of Hyndman and
 *   Fan, as NumPy and spreadsheets do).
 * @property median the same for 50 %.
 * @property percentile95 the same for 95 %.
 * @property first the first finite value.
 * @property last the last finite value.
 * @property integral the area under the samples by the trapezoid rule, gaps left out.
 */
public data class SeriesStatistics(
    public val count: Int,
    public val gaps: Int,
    public val min: Double,
    public val max: Double,
    public val mean: Double,
    public val standardDeviation: Double,
    public val percentile5: Double,
    public val median: Double,
    public val percentile95: Double,
    public val first: Double,
    public val last: Double,
    public val integral: Double,
)

/** The statistics of the samples whose x lies from [from] to [to], both included. */
public fun Series.statistics(
    from: Double = Double.NEGATIVE_INFINITY,
    to: Double = Double.POSITIVE_INFINITY,
): SeriesStatistics {
    val values = DoubleArray(size)
    var count = 0
    var gaps = 0
    val area = TrapezoidSum()
    // Welford's recurrence (1962): mean and squares in one pass, without the cancellation of sums of squares.
    var mean = 0.0
    var squares = 0.0
    for (i in 0 until size) {
        if (x[i] !in from..to) {
            area.interrupt()
            continue
        }
        val value = y[i]
        area.add(x[i], value)
        if (!value.isFinite()) {
            gaps++
            continue
        }
        values[count++] = value
        val distance = value - mean
        mean += distance / count
        squares += distance * (value - mean)
    }
    val first = if (count > 0) values[0] else Double.NaN
    val last = if (count > 0) values[count - 1] else Double.NaN
    values.sort(0, count)
    return SeriesStatistics(
        count = count,
        gaps = gaps,
        min = if (count > 0) values[0] else Double.NaN,
        max = if (count > 0) values[count - 1] else Double.NaN,
        mean = if (count > 0) mean else Double.NaN,
        standardDeviation = if (count > 1) sqrt(squares / (count - 1)) else Double.NaN,
        percentile5 = percentile(values, count, 0.05),
        median = percentile(values, count, 0.5),
        percentile95 = percentile(values, count, 0.95),
        first = first,
        last = last,
        integral = if (count > 0) area.value else Double.NaN,
    )
}

private fun percentile(sorted: DoubleArray, count: Int, share: Double): Double {
    if (count == 0) return Double.NaN
    val place = share * (count - 1)
    val below = place.toInt()
    val above = minOf(below + 1, count - 1)
    return sorted[below] + (sorted[above] - sorted[below]) * (place - below)
}
