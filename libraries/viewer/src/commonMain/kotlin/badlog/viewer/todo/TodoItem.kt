package badlog.viewer.todo

import badlog.core.recording.Severity
import badlog.viewer.text.countText

/**
 * An item of a team's list.
 *
 * @property task the task.
 * @property isOpen whether it is still to be done.
 * @property person the person who takes it on; empty if there is none.
 * @property done the last time that it was done; null if it never was. An open item that was done has been reopened by a person, or
 *   [isAgain].
 * @property isAgain whether it is open because the fault was found again in a log that was recorded after it was [done].
 * @property found the last place of the fault; null if no rule found it, or if the logs of the folder no longer show it.
 */
data class TodoItem(
    val task: TodoTask,
    val isOpen: Boolean,
    val person: String = "",
    val done: DoneMark? = null,
    val isAgain: Boolean = false,
    val found: LastFound? = null,
) {
    /** The task in a few words. */
    val title: String
        get() = when (task) {
            is FaultTask -> task.rule
            is NoteTask -> task.text
            is OwnTask -> task.text
        }
}

/**
 * The last place of a fault.
 *
 * @property log the last log with the fault.
 * @property fault the finding in that log.
 * @property runs the number of matches and other runs with the fault.
 */
data class LastFound(val log: TodoLog, val fault: FoundFault, val runs: Int) {
    /** The severity of the fault. */
    val severity: Severity get() = fault.severity
}

/** A record that something was done: [change] with its [deed]. */
data class DoneMark(private val change: TodoChange, private val deed: TodoDeed.Done) {
    /** The work that was done; may be empty. */
    val what: String get() = deed.what

    /** The person who did it. */
    val by: String get() = change.author

    /** The match before which it was done; null if not given. */
    val before: String? get() = deed.before

    /** A key that orders marks by time. */
    internal val order: String get() = change.time + change.id

    /** Returns whether [log] was recorded after the item was done. */
    internal fun isBefore(log: TodoLog): Boolean = change.isBefore(log, deed.before)
}

/** The note on an item that came back: `Again, after it was done before Qualification 58.`; otherwise empty. */
val TodoItem.againText: String
    get() = done?.takeIf { isAgain }?.let { mark ->
        "Again, after it was done ${mark.before?.let(::momentText) ?: "by ${mark.by}"}."
    }.orEmpty()

/** The mark in words: `Done before Qualification 58 by Ada: replaced main breaker`. */
val DoneMark.text: String
    get() = "Done${before?.let { " ${momentText(it)}" }.orEmpty()} by $by${if (what.isEmpty()) "" else ": $what"}"

/** Returns `before Qualification 58`, or `after Qualification 57` if the next match was not named. */
private fun momentText(before: String) = if (before.startsWith(AFTER)) "after ${before.removePrefix(AFTER)}" else "before $before"

/** The details of the item besides its title, one per line: that it came back, the work done, the finding, and the origin. */
val TodoItem.lines: List<String>
    get() = listOfNotNull(
        againText.ifEmpty { null },
        done?.takeIf { !isOpen || isAgain }?.text,
        found?.fault?.text,
        placeText.ifEmpty { null },
    )

/**
 * The origin of the item: `Found in Qualification 60, and 2 logs before.` or `A note in q58.bag.`. Empty for a task in the team's own
 * words.
 */
val TodoItem.placeText: String
    get() = when (val task = task) {
        is NoteTask -> "A note in ${task.log}."

        is OwnTask -> ""

        is FaultTask -> found?.let { last ->
            val before = last.runs - 1
            "Found in ${last.log.title}" + if (before > 0) ", and ${countText(before, "log")} before." else "."
        } ?: "The logs of this folder do not show it."
    }

/** The title of the checklist before [match]. */
fun checklistTitle(match: String): String = "Checklist before $match"
