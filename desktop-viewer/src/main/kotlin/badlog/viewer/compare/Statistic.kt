package badlog.viewer.compare

import badlog.analysis.SeriesStatistics
import badlog.analysis.Units
import badlog.recording.Topic

/**
 * A figure that the table across recordings can have.
 *
 * @property title what the window calls it.
 * @property isSample whether it is one of the samples, rather than calculated from them.
 * @property of finds it; NaN where there is none.
 */
internal enum class Statistic(val title: String, val isSample: Boolean = false, val of: (SeriesStatistics) -> Double) {
    MIN("min", isSample = true, of = { it.min }),
    MAX("max", isSample = true, of = { it.max }),
    MEAN("mean", of = { it.mean }),
    MEDIAN("median", of = { it.median }),
    PERCENTILE_5("5 %", of = { it.percentile5 }),
    PERCENTILE_95("95 %", of = { it.percentile95 }),
    STANDARD_DEVIATION("std", of = { it.standardDeviation }),
    FIRST("first", isSample = true, of = { it.first }),
    LAST("last", isSample = true, of = { it.last }),
    CHANGE("change", of = { it.last - it.first }),
    INTEGRAL("integral", of = { it.integral }),
    SAMPLES("samples", of = { it.count.toDouble() }),
    ;

    /** Its unit for a topic of [unit] over an x of [xUnit], null where that is not known; `ul` for none. */
    fun unitOf(unit: String, xUnit: String?): String = when (this) {
        INTEGRAL -> if (xUnit == null) Topic.UNITLESS else Units.ofIntegral(unit, xUnit)
        SAMPLES -> Topic.UNITLESS
        else -> unit
    }
}
