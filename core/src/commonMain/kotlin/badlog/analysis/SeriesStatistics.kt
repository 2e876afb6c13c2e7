package badlog.analysis

import kotlin.math.sqrt

/**
 * What a series does over a range of x. Every figure but the counts is NaN when there is no value in the range.
 *
 * @property count how many samples of the range have a finite value.
 * @property gaps how many have none.
 * @property mean the arithmetic mean of the samples, not weighted by time.
 * @property standardDeviation of a sample, dividing by `count - 1`; NaN for fewer than two values.
 * @property percentile5 the value below which 5 % lie, interpolated linearly between neighbors (type 7 of Hyndman and
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

/**
 * The statistics of the samples whose x lies from [from] to [to], both included. In a series that is ordered it looks at
 * those alone; it allocates one array for them.
 */
public fun Series.statistics(from: Double = Double.NEGATIVE_INFINITY, to: Double = Double.POSITIVE_INFINITY): SeriesStatistics {
    val begin = if (isOrdered) firstAtOrAfter(from) else 0
    val end = if (isOrdered) firstAfter(to) else size
    val values = DoubleArray(maxOf(0, end - begin))
    var count = 0
    var gaps = 0
    var min = Double.NaN
    var max = Double.NaN
    val area = TrapezoidSum()
    // Welford's recurrence (1962): mean and squares in one pass, without the cancellation of sums of squares.
    var mean = 0.0
    var squares = 0.0
    for (i in begin until end) {
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
        min = if (count == 0) value else minOf(min, value)
        max = if (count == 0) value else maxOf(max, value)
        values[count++] = value
        val distance = value - mean
        mean += distance / count
        squares += distance * (value - mean)
    }
    val first = if (count > 0) values[0] else Double.NaN
    val last = if (count > 0) values[count - 1] else Double.NaN
    val percentiles = Percentiles(values, count)
    return SeriesStatistics(
        count = count,
        gaps = gaps,
        min = min,
        max = max,
        mean = if (count > 0) mean else Double.NaN,
        standardDeviation = if (count > 1) sqrt(squares / (count - 1)) else Double.NaN,
        percentile5 = percentiles.low,
        median = percentiles.median,
        percentile95 = percentiles.high,
        first = first,
        last = last,
        integral = if (count > 0) area.value else Double.NaN,
    )
}

/**
 * The percentiles of the first [count] of [values], which are not NaN and change their places: interpolated linearly between
 * neighbors, see [SeriesStatistics.percentile5]. NaN without values.
 */
internal class Percentiles(private val values: DoubleArray, private val count: Int) {
    /** The value below which 5 % lie. */
    val low: Double

    /** The value below which half lie. */
    val median: Double

    /** The value below which 95 % lie. */
    val high: Double

    init {
        val lowPlace = placeOf(LOW)
        val middle = placeOf(MEDIAN)
        val highPlace = placeOf(HIGH)
        // Each selection leaves less to the next: what is before the middle stays before it.
        select(values, middle, 0, count)
        select(values, lowPlace, 0, middle)
        select(values, highPlace, middle + 1, count)
        low = interpolated(LOW, lowPlace, middle)
        median = interpolated(MEDIAN, middle, highPlace)
        high = interpolated(HIGH, highPlace, count - 1)
    }

    private fun placeOf(share: Double) = (share * (count - 1)).toInt()

    /** Between the value at [below] and the smallest of those behind it, which stands at [last] at the latest. */
    private fun interpolated(share: Double, below: Int, last: Int): Double {
        if (count == 0) return Double.NaN
        var above = if (below == count - 1) values[below] else values[below + 1]
        for (i in below + 2..last) if (values[i] < above) above = values[i]
        return values[below] + (above - values[below]) * (share * (count - 1) - below)
    }

    private companion object {
        const val LOW = 0.05
        const val MEDIAN = 0.5
        const val HIGH = 0.95
    }
}
