package badlog.viewer.library.index

/** How many seconds [duration] in [unit] is; null when the unit is none of time. */
internal fun secondsOf(duration: Double, unit: String): Double? = when (unit.trim().lowercase()) {
    "s", "sec", "secs", "second", "seconds" -> duration
    // A log without units is a plain CSV file, whose time nearly always is in seconds.
    "", "ul" -> duration
    "ms", "millis", "milliseconds" -> duration / 1e3
    "us", "µs", "μs", "microseconds" -> duration / 1e6
    "ns", "nanoseconds" -> duration / 1e9
    "min", "minutes" -> duration * 60
    else -> null
}
