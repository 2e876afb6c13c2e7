package badlog.analysis

/**
 * The percentiles of the first [count] of [values], which are not NaN and change their places: interpolated linearly between
 * neighbours, see [SeriesStatistics.percentile5]. NaN without values.
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
