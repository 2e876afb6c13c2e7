package badlog.viewer.choices

import java.time.DateTimeException
import java.time.Instant
import java.time.ZoneOffset
import java.time.format.DateTimeFormatter
import java.time.temporal.ChronoUnit

/**
 * Returns the time of a change that is made now, in UTC: `2026-03-07T14:05:12.345Z`; such times are in order as texts.
 *
 * @param last the time of the newest change that is known: even if the clock of the laptop that made it is ahead, what is changed later counts.
 */
fun changeTime(last: String?): String {
    val now = Instant.now().truncatedTo(ChronoUnit.MILLIS)
    val known = last?.let(::instantOf)?.takeIf { it < now.plus(LARGEST_LEAD, ChronoUnit.HOURS) }
    return TIME.format(if (known != null && known >= now) known.plusMillis(1) else now)
}

private fun instantOf(text: String): Instant? = try {
    Instant.parse(text)
} catch (_: DateTimeException) {
    null
}

private val TIME: DateTimeFormatter = DateTimeFormatter.ofPattern("yyyy-MM-dd'T'HH:mm:ss.SSS'Z'").withZone(ZoneOffset.UTC)

/** In hours: a clock that is more ahead than this is wrong, and must not take the others along. */
private const val LARGEST_LEAD = 24L
