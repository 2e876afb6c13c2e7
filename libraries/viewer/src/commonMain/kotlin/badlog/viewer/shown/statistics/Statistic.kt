package badlog.viewer.shown.statistics

import badlog.core.analysis.SeriesStatistics
import badlog.core.analysis.Units
import badlog.core.recording.Topic
import badlog.viewer.text.countText
import badlog.viewer.text.numberText

/**
 * A number that describes the samples of a range. It is weighted by time rather than by samples where both are possible: a value that
 * holds longer has more weight, however often it was logged; see [badlog.core.analysis.SeriesStatistics].
 *
 * @property title the label in front ends.
 * @property hint an explanation for beginners.
 * @property isCount whether it is a number of samples.
 */
enum class Statistic(val title: String, val hint: String, val isCount: Boolean = false) {
    /** The smallest value. */
    MIN("min", "the smallest value"),

    /** The largest value. */
    MAX("max", "the largest value"),

    /** The mean by time. */
    MEAN("mean", "the mean by time: each value counts as long as it holds"),

    /** The median by time: values are below it for half of the time. */
    MEDIAN("median", "below this for half of the time"),

    /** The 5th percentile by time: values are below it for 5 % of the time. */
    PERCENTILE_5("5 %", "below this for 5 % of the time"),

    /** The 95th percentile by time: values are below it for 95 % of the time. */
    PERCENTILE_95("95 %", "below this for 95 % of the time"),

    /** The standard deviation by time. */
    STANDARD_DEVIATION("std. dev.", "the standard deviation by time: each value counts as long as it holds"),

    /** The first value. */
    FIRST("first", "the first value"),

    /** The last value. */
    LAST("last", "the last value"),

    /** The last value minus the first. */
    CHANGE("last − first", "the last value minus the first"),

    /** The area under the values. */
    INTEGRAL("integral", "the area under the values, each as long as it holds"),

    /** The number of samples with a value. */
    SAMPLES("samples", "how many samples have a value", isCount = true),

    /** The number of samples without a value. */
    GAPS("gaps", "how many samples have no value", isCount = true),
    ;

    /** Returns the value of this statistic in [statistics]; NaN if there is none. */
    fun of(statistics: SeriesStatistics): Double = when (this) {
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

    /** Returns the displayed [value], a result of [of]: counts in full, other numbers with a few digits; `–` for NaN. */
    fun textOf(value: Double): String = if (isCount && !value.isNaN()) countText(value.toInt()) else numberText(value)

    /** Returns the unit of this statistic for a topic of [unit]; `ul` if it has none. [xUnit] is the unit of x, null if unknown. */
    fun unitOf(unit: String, xUnit: String?): String = when {
        isCount -> Topic.UNITLESS
        this != INTEGRAL -> unit
        xUnit == null -> Topic.UNITLESS
        else -> Units.ofIntegral(unit, xUnit)
    }

    companion object {
        /** The displayed remark that statistics are weighted by time. */
        const val BY_TIME: String = "Mean, median, percentiles and standard deviation are by time."
    }
}
