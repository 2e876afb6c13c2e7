package badlog.viewer.library.index

import badlog.analysis.Units

/** How many seconds [duration] in [unit] is; null when the unit is none of time. */
internal fun secondsOf(duration: Double, unit: String): Double? {
    // A log without units is a plain CSV file, whose time nearly always is in seconds.
    val seconds = if (unit.isBlank() || Units.isNone(unit)) 1.0 else Units.secondsIn(unit)
    return seconds?.let { duration * it }
}
