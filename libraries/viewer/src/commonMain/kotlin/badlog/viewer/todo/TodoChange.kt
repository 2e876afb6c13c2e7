package badlog.viewer.todo

/**
 * One change of a team's list: one line of a file that is only ever appended to.
 *
 * @property id identifies it among all laptops.
 * @property time when it was made, in UTC: `2026-03-07T14:05:12.345Z`; such times are in order as texts.
 * @property author who made it.
 * @property subject what it is about.
 * @property deed what changed.
 * @property seen when the last log began that was known then, in s since 1970 on the clock of the logs; null if there was none. What was
 * recorded later is decided by the logs' own clock, because that of a robot is often wrong, or in another time zone.
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

/** What changed about the subject of a [TodoChange]. */
sealed interface TodoDeed {
    /** It is to be done: it is on the list from now on, or once more. */
    data object Open : TodoDeed

    /** It is not to be done after all. */
    data object Remove : TodoDeed

    /**
     * Somebody takes it on.
     *
     * @property person who; empty for nobody.
     */
    data class Assign(val person: String) : TodoDeed

    /**
     * It is done.
     *
     * @property what what was done, such as `replaced main breaker`; may be empty.
     * @property before the match before which it was done; null if not given.
     */
    data class Done(val what: String = "", val before: String? = null) : TodoDeed
}
