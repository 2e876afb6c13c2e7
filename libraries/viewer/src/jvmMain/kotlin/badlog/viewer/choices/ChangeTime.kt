package badlog.viewer.choices

import java.time.DateTimeException
import java.time.Instant
import java.time.ZoneOffset
import java.time.format.DateTimeFormatter
import java.time.temporal.ChronoUnit

/**
 * Returns the time of a change that is made now, in UTC: `2026-03-07T14:05:12.345Z`. Sorted as texts, such times are in order.
 *
 * @param last the time of the newest known change of the same thing; null if there is none. The result is later, even if that change was
 *   made on a laptop with its clock ahead.
 */
fun changeTime(last: String?): String {
    val now = Instant.now().truncatedTo(ChronoUnit.MILLIS)
    val next = last?.let(::instantOf)?.plusMillis(1)
    return TIME.format(if (next == null) now else minOf(maxOf(now, next), LAST))
}

private fun instantOf(text: String): Instant? = try {
    Instant.parse(text)
} catch (_: DateTimeException) {
    null
}

private val TIME: DateTimeFormatter = DateTimeFormatter.ofPattern("yyyy-MM-dd'T'HH:mm:ss.SSS'Z'").withZone(ZoneOffset.UTC)

/** The last time with a year of four digits. */
private val LAST: Instant = Instant.parse("9999-12-31T23:59:59.999Z")
