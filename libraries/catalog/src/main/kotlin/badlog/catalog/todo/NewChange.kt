package badlog.catalog.todo

import badlog.viewer.todo.FoundLog
import badlog.viewer.todo.TodoChange
import badlog.viewer.todo.TodoDeed
import badlog.viewer.todo.TodoSubject
import java.time.Instant
import java.time.ZoneOffset
import java.time.format.DateTimeFormatter
import java.time.temporal.ChronoUnit
import java.util.UUID

/**
 * Returns the change that [author] makes to [subject] now.
 *
 * @param last the log of the folder that began last; null if there is none.
 * @param before the newest change that is known: even if another laptop's clock is ahead, what is changed later counts.
 */
fun newChange(subject: TodoSubject, deed: TodoDeed, author: String, last: FoundLog?, before: TodoChange? = null): TodoChange {
    val now = Instant.now().truncatedTo(ChronoUnit.MILLIS)
    val known = before?.let { instantOf(it.time) }?.takeIf { it < now.plus(LARGEST_LEAD, ChronoUnit.HOURS) }
    val time = if (known != null && known >= now) known.plusMillis(1) else now
    val id = UUID.randomUUID().toString()
    return TodoChange(id, TIME.format(time), author.trim().take(TodoChange.MAX_TEXT), subject, deed, last?.second, last?.match?.event)
}

private fun instantOf(time: String): Instant? = runCatching { Instant.parse(time) }.getOrNull()

private val TIME: DateTimeFormatter = DateTimeFormatter.ofPattern("yyyy-MM-dd'T'HH:mm:ss.SSS'Z'").withZone(ZoneOffset.UTC)

/** In hours: a clock that is more ahead than this is wrong, and must not take the others along. */
private const val LARGEST_LEAD = 24L
