package badlog.core.analysis

import badlog.core.recording.Topic

/** Functions that recognize, derive and convert units. */
public object Units {
    /** Returns whether [unit] stands for no unit: it is `ul` or blank. */
    public fun isNone(unit: String): Boolean = unit.isBlank() || unit == Topic.UNITLESS

    /**
     * Returns the unit of a derivative: `unit/xunit`. An x axis without a unit counts as `Index`; for a topic
     * without a unit the result is per x, such as `1/s`.
     */
    public fun ofDerivative(unit: String, xUnit: String): String = "${if (isNone(unit)) "1" else unit}/${ofX(xUnit)}"

    /** Returns the unit of an integral: `unit·xunit`, or the unit of x alone if the topic has none. */
    public fun ofIntegral(unit: String, xUnit: String): String = if (isNone(unit)) ofX(xUnit) else "$unit·${ofX(xUnit)}"

    /** Returns the number of seconds in one [unit], such as 0.001 for `ms` and `Milliseconds`. Null if it is not a unit of time. */
    public fun secondsIn(unit: String): Double? = when (unit.trim().lowercase()) {
        "h", "hr", "hrs", "hour", "hours" -> 3600.0

        "min", "mins", "minute", "minutes" -> 60.0

        "s", "sec", "secs", "second", "seconds" -> 1.0

        "ms", "msec", "msecs", "millis", "millisecond", "milliseconds" -> 1e-3

        // Both characters for micro.
        "us", "\u00b5s", "\u03bcs", "usec", "usecs", "micros", "microsecond", "microseconds" -> 1e-6

        "ns", "nsec", "nsecs", "nanos", "nanosecond", "nanoseconds" -> 1e-9

        else -> null
    }

    /** Returns the number of microseconds in one [unit] of an x axis. Anything that is not a unit of time counts as a second. */
    public fun microsIn(unit: String): Double = (secondsIn(unit) ?: 1.0) * 1e6

    private fun ofX(xUnit: String) = if (isNone(xUnit)) "Index" else xUnit
}
