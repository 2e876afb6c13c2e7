package badlog.catalog.todo

import badlog.signals.match.localSecondOf
import badlog.viewer.choices.changeTime
import badlog.viewer.todo.Check
import badlog.viewer.todo.NextMatch
import badlog.viewer.todo.TodoChange
import badlog.viewer.todo.TodoDeed
import badlog.viewer.todo.TodoLog
import badlog.viewer.todo.TodoSubject
import java.util.UUID

/**
 * Returns a change by [author] to [subject] at the current time.
 *
 * @param last the latest log of the folder; null if none is known. A log from days ago does not determine the next match.
 * @param known the known changes. The new one is later than all others of the same subject, whatever the clocks of the laptops show.
 * @param now the local time of this computer, in s.
 */
fun newChange(
    subject: TodoSubject,
    deed: TodoDeed,
    author: String,
    last: TodoLog?,
    known: Collection<TodoChange> = emptyList(),
    now: Long = localSecondOf(System.currentTimeMillis() / MILLIS),
): TodoChange {
    // Older logs are of another event with the same match numbers.
    val recent = last?.takeIf { now - it.second <= LONGEST_REST }
    val before = known.filter { supersedes(it.subject, subject) }.maxOfOrNull { it.time }
    return TodoChange(
        UUID.randomUUID().toString(),
        changeTime(before),
        author.trim().take(TodoChange.MAX_TEXT),
        subject,
        deed,
        recent?.second ?: now,
        recent?.match?.event,
    )
}

/** Returns whether only the later of two changes of [one] and [other] may count. */
private fun supersedes(one: TodoSubject, other: TodoSubject): Boolean = when (other) {
    // Ticks made before the match had a name belong to it.
    is NextMatch -> one is NextMatch || one is Check

    // A tick made before the match had a name is removed under that name.
    is Check -> one is NextMatch || (one is Check && one.text == other.text)

    else -> one == other
}

private const val MILLIS = 1000L

/** The longest time between two logs of one event, in s. */
private const val LONGEST_REST = 2 * 86_400L
