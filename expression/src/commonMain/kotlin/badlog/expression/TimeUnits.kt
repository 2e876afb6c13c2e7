package badlog.expression

/** How much of x a second is, where x is a time in [unit]; 1 where it is none. */
internal fun perSecond(unit: String): Double = when (unit.trim().lowercase()) {
    "ms" -> 1e3
    "us", "µs", "μs" -> 1e6
    "ns" -> 1e9
    "min" -> 1 / 60.0
    "h" -> 1 / 3600.0
    else -> 1.0
}
