package badlog.viewer.todo

import badlog.core.recording.Severity

/**
 * An item of a team's list.
 *
 * @property task what is to be done.
 * @property isOpen whether it is still to be done.
 * @property person who takes it on; empty for nobody.
 * @property done the last time that it was done; null if it never was. An open item that was done has been opened by a person, or [isAgain].
 * @property isAgain whether it is open because it was found again in a log that was recorded after it was [done].
 * @property found where it was found last; null for what no rule found, and if the logs of the folder do not show it any more.
 */
data class TodoItem(
    val task: TodoTask,
    val isOpen: Boolean,
    val person: String = "",
    val done: DoneMark? = null,
    val isAgain: Boolean = false,
    val found: LastFound? = null,
) {
    /** What is to be done, in a few words. */
    val title: String
        get() = when (task) {
            is FaultTask -> task.rule
            is NoteTask -> task.text
            is OwnTask -> task.text
        }
}

/**
 * Where a fault was found last.
 *
 * @property log the log.
 * @property fault what was found there.
 * @property runs the number of matches and other runs in which it was found.
 */
data class LastFound(val log: FoundLog, val fault: FoundFault, val runs: Int) {
    /** How serious it is. */
    val severity: Severity get() = fault.severity
}

/** Says that something was done, in [change], whose deed is [deed]. */
data class DoneMark(private val change: TodoChange, private val deed: TodoDeed.Done) {
    /** What was done; may be empty. */
    val what: String get() = deed.what

    /** Who did it. */
    val by: String get() = change.author

    /** The match before which it was done; null if not given. */
    val before: String? get() = deed.before

    /** Where it stands among others, by time. */
    internal val order: String get() = change.time + change.id

    /** Returns whether [log] was recorded after it was done. */
    internal fun isBefore(log: FoundLog): Boolean = change.isBefore(log, deed.before)
}
