package badlog.formats.column

/**
 * Returns time 0 of a log with the earliest time [firstMicros], both in µs. It is that time if it counts from 1970, as the clock of a laptop does,
 * otherwise 0. A robot that counts from its start would have to run for 31 years.
 */
internal fun originOf(firstMicros: Double): Double = if (firstMicros in FIRST..LAST) firstMicros else 0.0

/** September 2001 and the end of 2096, in µs since 1970. */
private const val FIRST = 1e15
private const val LAST = 4e15
