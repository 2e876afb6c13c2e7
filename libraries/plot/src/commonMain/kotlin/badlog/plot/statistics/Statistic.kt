package badlog.plot.statistics

import badlog.analysis.SeriesStatistics
import badlog.analysis.Units
import badlog.plot.text.exactText
import badlog.plot.text.roundedText
import badlog.recording.Topic

/**
 * A number that tells about the samples of a range. Those that could count samples or time count time: a value that holds long
 * weighs much, however often it was logged; see [badlog.analysis.SeriesStatistics].
 *
 * @property title what the front ends call it.
 * @property hint what it is, for who does not know it by its title.
 * @property isSample whether it is one of the samples, rather than calculated from them.
 * @property isCount whether it counts samples.
 */
public enum class Statistic(
    public val title: String,
    public val hint: String,
    public val isSample: Boolean = false,
    public val isCount: Boolean = false,
) {
    /** The smallest value. */
    MIN("min", "the smallest value", isSample = true),

    /** The largest value. */
    MAX("max", "the largest value", isSample = true),

    /** The mean by time. */
    MEAN("mean", "the mean by time: each value counts as long as it holds"),

    /** Below this for half of the time. */
    MEDIAN("median", "below this for half of the time"),

    /** Below this for 5 % of the time. */
    PERCENTILE_5("5 %", "below this for 5 % of the time"),

    /** Below this for 95 % of the time. */
    PERCENTILE_95("95 %", "below this for 95 % of the time"),

    /** The standard deviation by time. */
    STANDARD_DEVIATION("std", "the standard deviation by time: each value counts as long as it holds"),

    /** The first value. */
    FIRST("first", "the first value", isSample = true),

    /** The last value. */
    LAST("last", "the last value", isSample = true),

    /** By how much the last value is above the first. */
    CHANGE("last − first", "the last value minus the first"),

    /** The area under the values. */
    INTEGRAL("integral", "the area under the values, each as long as it holds"),

    /** How many samples have a value. */
    SAMPLES("samples", "how many samples have a value", isCount = true),

    /** How many samples have none. */
    GAPS("gaps", "how many samples have no value", isCount = true),
    ;

    /** Its value in [statistics]; NaN where there is none. */
    public fun of(statistics: SeriesStatistics): Double = when (this) {
        MIN -> statistics.min
        MAX -> statistics.max
        MEAN -> statistics.mean
        MEDIAN -> statistics.median
        PERCENTILE_5 -> statistics.percentile5
        PERCENTILE_95 -> statistics.percentile95
        STANDARD_DEVIATION -> statistics.standardDeviation
        FIRST -> statistics.first
        LAST -> statistics.last
        CHANGE -> statistics.last - statistics.first
        INTEGRAL -> statistics.integral
        SAMPLES -> statistics.count.toDouble()
        GAPS -> statistics.gaps.toDouble()
    }

    /**
     * Its value in [statistics] as text: a sample exactly as it was logged, but without the digits that a calculation makes up, as
     * where the samples themselves are [isDerived].
     */
    public fun textOf(statistics: SeriesStatistics, isDerived: Boolean): String {
        val value = of(statistics)
        return if (isCount || (isSample && !isDerived)) exactText(value) else roundedText(value)
    }

    /** Its unit for a topic of [unit] over an x of [xUnit], null where that is not known; `ul` for none. */
    public fun unitOf(unit: String, xUnit: String?): String = when {
        isCount -> Topic.UNITLESS
        this != INTEGRAL -> unit
        xUnit == null -> Topic.UNITLESS
        else -> Units.ofIntegral(unit, xUnit)
    }

    public companion object {
        /** What stands beside the figures, so that nobody takes them for those of the samples. */
        public const val BY_TIME: String = "Mean, median, percentiles and std are by time."
    }
}
