package badlog.viewer.compare

import badlog.analysis.SeriesStatistics
import badlog.analysis.Units
import badlog.recording.Topic

/**
 * A figure that the table across recordings can have.
 *
 * @property title what the window calls it.
 * @property of finds it; NaN where there is none.
 */
internal enum class Statistic(val title: String, val of: (SeriesStatistics) -> Double) {
    MIN("min", { it.min }),
    MAX("max", { it.max }),
    MEAN("mean", { it.mean }),
    MEDIAN("median", { it.median }),
    PERCENTILE_5("5 %", { it.percentile5 }),
    PERCENTILE_95("95 %", { it.percentile95 }),
    STANDARD_DEVIATION("std", { it.standardDeviation }),
    FIRST("first", { it.first }),
    LAST("last", { it.last }),
    CHANGE("change", { it.last - it.first }),
    INTEGRAL("integral", { it.integral }),
    SAMPLES("samples", { it.count.toDouble() }),
    ;

    /** Its unit for a topic of [unit] over an x of [xUnit], null where that is not known; `ul` for none. */
    fun unitOf(unit: String, xUnit: String?): String = when (this) {
        INTEGRAL -> if (xUnit == null) Topic.UNITLESS else Units.ofIntegral(unit, xUnit)
        SAMPLES -> Topic.UNITLESS
        else -> unit
    }
}
