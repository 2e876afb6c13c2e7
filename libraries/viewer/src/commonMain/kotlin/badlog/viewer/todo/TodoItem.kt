package badlog.viewer.todo

import badlog.core.recording.Severity

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
