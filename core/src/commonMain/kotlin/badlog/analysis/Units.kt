package badlog.analysis

import badlog.recording.Topic

/** How units are shown and derived. */
public object Units {
    /** Whether [unit] means that there is none: `ul`, or nothing. */
    public fun isNone(unit: String): Boolean = unit.isBlank() || unit == Topic.UNITLESS

    /**
     * The unit of a derivative: `unit/xunit`. An x axis without a unit counts as `Index`; without a unit of its own the
     * derivative is per x, `1/s`.
     */
    public fun ofDerivative(unit: String, xUnit: String): String = "${if (isNone(unit)) "1" else unit}/${ofX(xUnit)}"

    /** The unit of an integral: `unit·xunit`, or that of x alone where the topic has none. */
    public fun ofIntegral(unit: String, xUnit: String): String =
        if (isNone(unit)) ofX(xUnit) else "$unit·${ofX(xUnit)}"

    /** How many microseconds one [unit] of an x axis is; what is no unit of time counts as a second. */
    internal fun microsIn(unit: String): Double = when (unit) {
        "ms" -> 1e3
        "us", "µs" -> 1.0
        else -> 1e6
    }

    private fun ofX(xUnit: String) = if (isNone(xUnit)) "Index" else xUnit
}
