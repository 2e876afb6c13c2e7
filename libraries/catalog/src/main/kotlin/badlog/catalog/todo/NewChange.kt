package badlog.catalog.todo

import badlog.signals.match.localSecondOf
import badlog.viewer.choices.changeTime
import badlog.viewer.todo.Check
import badlog.viewer.todo.FoundLog
import badlog.viewer.todo.NextMatch
import badlog.viewer.todo.TodoChange
import badlog.viewer.todo.TodoDeed
import badlog.viewer.todo.TodoSubject
import java.util.UUID

/**
 * Returns the change that [author] makes to [subject] now.
 *
 * @param last the log of the folder that began last; null if none is known. One of days before says nothing of the match that comes.
 * @param known the changes that are known: this one is later than those of the same subject, whatever the clocks of their laptops say.
 * @param now the second of this computer's clock, in its own time zone.
 */
fun newChange(
    subject: TodoSubject,
    deed: TodoDeed,
    author: String,
    last: FoundLog?,
    known: Collection<TodoChange> = emptyList(),
    now: Long = localSecondOf(System.currentTimeMillis() / MILLIS),
): TodoChange {
    // Logs of days before are of another event, whose matches have the same numbers.
    val recent = last?.takeIf { now - it.second <= LONGEST_REST }
    val before = known.filter { competes(it.subject, subject) }.maxOfOrNull { it.time }
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

/** Returns whether of changes of [one] and [other] only the last may count. */
private fun competes(one: TodoSubject, other: TodoSubject): Boolean = when (other) {
    // Ticks that were made before the match had a name belong to it.
    is NextMatch -> one is NextMatch || one is Check

    // A tick that was made before the match had a name is taken off under that name.
    is Check -> one is NextMatch || (one is Check && one.text == other.text)

    else -> one == other
}

private const val MILLIS = 1000L

/** Between two logs of one event, in s. */
private const val LONGEST_REST = 2 * 86_400L
