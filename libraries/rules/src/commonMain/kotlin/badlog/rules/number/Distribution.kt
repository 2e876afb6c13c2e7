package badlog.rules.number

import badlog.core.analysis.Series
import badlog.core.analysis.weightedPercentile

/**
 * The distribution of a signal's values over the time in which the robot was enabled, in a few numbers. The numbers of many logs fit in memory, and
 * can be drawn beside each other.
 *
 * @property signal the name of the signal.
 * @property unit the unit of the values, empty for none.
 * @property quantiles the quantiles of the values over time at [SHARES]; the first is the smallest value, the last the largest.
 * @property binWidth the width of a bin in [seconds], in [unit]; 0 without bins.
 * @property seconds the time in each bin, in s; the first bin begins at 0, the last one also has everything larger.
 */
class Distribution internal constructor(
    val signal: String,
    val unit: String,
    val quantiles: List<Double>,
    val binWidth: Double,
    val seconds: List<Double>,
) {
    /** The smallest value. */
    val lowest: Double get() = quantiles.first()

    /** The 5th percentile: the signal is below it for a twentieth of the time. */
    val percentile5: Double get() = quantiles[1]

    /** The lower quartile: the signal is below it for a quarter of the time. */
    val lowerQuartile: Double get() = quantiles[2]

    /** The median: the signal is below it for half of the time. */
    val median: Double get() = quantiles[3]

    /** The upper quartile: the signal is above it for a quarter of the time. */
    val upperQuartile: Double get() = quantiles[4]

    /** The 95th percentile: the signal is above it for a twentieth of the time. */
    val percentile95: Double get() = quantiles[5]

    /** The largest value. */
    val highest: Double get() = quantiles.last()

    companion object {
        /** The shares of the time to which [quantiles] belong. */
        val SHARES: List<Double> = listOf(0.0, 0.05, 0.25, 0.5, 0.75, 0.95, 1.0)
    }
}

/**
 * A signal with a distribution that is worth keeping.
 *
 * @property above the smallest value that counts: libraries log 0 before the first measurement.
 * @property binWidth the width of a bin, in the unit of the signal; 0 for no bins.
 * @property bins the number of bins.
 */
internal class DistributedSignal(val signal: String, val above: Double, val binWidth: Double = 0.0, val bins: Int = 0) {
    /**
     * Returns the distribution of [series], weighted by [weights], which are times in the unit of x. Null if they total less than [least].
     * [second] is one second in that unit.
     */
    fun of(series: Series, weights: DoubleArray, unit: String, second: Double, least: Double): Distribution? {
        val values = DoubleArray(weights.size)
        val counted = DoubleArray(weights.size)
        var size = 0
        var time = 0.0
        val seconds = DoubleArray(bins)
        for (i in weights.indices) {
            val value = series.y[i]
            if (weights[i] <= 0 || !value.isFinite() || value < above) continue
            values[size] = value
            counted[size++] = weights[i]
            time += weights[i]
            if (bins > 0) seconds[(value / binWidth).toInt().coerceIn(0, bins - 1)] += weights[i] / second
        }
        if (time < least || time <= 0) return null
        val quantiles = Distribution.SHARES.map { share ->
            when (share) {
                0.0 -> smallest(values, size)
                1.0 -> largest(values, size)
                else -> weightedPercentile(values, counted, size, share)
            }
        }
        return Distribution(signal, unit, quantiles.map(::usefulDigits), binWidth, seconds.map(::usefulDigits))
    }

    private fun smallest(values: DoubleArray, size: Int): Double {
        var found = values[0]
        for (i in 1 until size) if (values[i] < found) found = values[i]
        return found
    }

    private fun largest(values: DoubleArray, size: Int): Double {
        var found = values[0]
        for (i in 1 until size) if (values[i] > found) found = values[i]
        return found
    }

    companion object {
        private const val MIN_VOLTS = 1.0

        val ALL = listOf(
            DistributedSignal("battery", above = MIN_VOLTS),
            DistributedSignal("loop time", above = 0.0, binWidth = 1.0, bins = 61),
            DistributedSignal("total current", above = 0.0),
        )
    }
}
