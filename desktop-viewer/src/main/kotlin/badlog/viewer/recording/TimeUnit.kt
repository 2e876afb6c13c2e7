package badlog.viewer.recording

/** How many seconds one [unit] is, such as 0.001 for `ms`; null when it is none of time. */
internal fun secondsPer(unit: String): Double? = when (unit.trim().lowercase()) {
    "s", "sec", "secs", "second", "seconds" -> 1.0
    "ms", "millis", "milliseconds" -> 1e-3
    "us", "µs", "μs", "microseconds" -> 1e-6
    "ns", "nanoseconds" -> 1e-9
    "min", "minutes" -> 60.0
    else -> null
}
