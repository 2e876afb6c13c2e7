package badlog.viewer.todo

/**
 * One change of a team's list: one line of a file that is only ever appended to.
 *
 * @property id identifies the change among all laptops.
 * @property time the time of the change, in UTC: `2026-03-07T14:05:12.345Z`; sorted as texts, such times are in order.
 * @property author the person who made the change.
 * @property subject the changed item.
 * @property deed the change.
 * @property seen the start of the last log that was known then, in s since 1970 on the clock of the logs; null if there was none. It
 *   decides which logs were recorded later, because a robot's clock is often wrong, or in another time zone.
 * @property event the event of that log; null if unknown.
 */
data class TodoChange(
    val id: String,
    val time: String,
    val author: String,
    val subject: TodoSubject,
    val deed: TodoDeed,
    val seen: Long? = null,
    val event: String? = null,
) {
    companion object {
        /** The maximum number of characters in each text of a change. */
        const val MAX_TEXT: Int = 2000
    }
}

/** The effect of a [TodoChange] on its subject. */
sealed interface TodoDeed {
    /** The item is to be done: it is on the list from now on, or once more. */
    data object Open : TodoDeed

    /** The item is not to be done after all. */
    data object Remove : TodoDeed

    /**
     * A person takes on the item.
     *
     * @property person the person; empty if the item is to be free again.
     */
    data class Assign(val person: String) : TodoDeed

    /**
     * The item is done.
     *
     * @property what the work that was done, such as `replaced main breaker`; may be empty.
     * @property before the match before which it was done; null if not given.
     */
    data class Done(val what: String = "", val before: String? = null) : TodoDeed
}

/**
 * The subject of a line in a to-do file. Its content identifies it, so two laptops that write about the same thing mean the same item.
 */
sealed interface TodoSubject

/** A task; an item of the list. */
sealed interface TodoTask : TodoSubject

/**
 * A fault that a rule finds, in any log.
 *
 * @property rule the name of the rule.
 * @property topic the topic of this fault, for a rule that is about each of many topics; null for any other rule.
 */
data class FaultTask(val rule: String, val topic: String?) : TodoTask

/**
 * A note about a moment of a log.
 *
 * @property log the name of the log's file.
 * @property x the moment, in the unit of the log's x axis; finite.
 * @property text the text of the note when it was put on the list.
 */
data class NoteTask(val log: String, val x: Double, val text: String) : TodoTask

/** Any other task, in the words of the team. */
data class OwnTask(val text: String) : TodoTask

/**
 * A line of the checklist before a match.
 *
 * @property text the line.
 * @property match the match as people call it, such as `Qualification 58`.
 */
data class Check(val text: String, val match: String) : TodoSubject

/** The match that the team plays next, such as `Qualification 61`: logs do not know the schedule. */
data class NextMatch(val match: String) : TodoSubject
