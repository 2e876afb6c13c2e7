package badlog.viewer.todo

/**
 * Returns the lines of the checklist that were ticked off before the match [next], with the person and the time.
 *
 * A tick is for one match: leaving the pit unchecked because of an earlier tick is worse than checking the robot twice. A tick stays if
 * it was made before the team named the next match.
 *
 * @param changes all changes, in their order.
 * @param logs the logs of the folder.
 */
internal fun ticksOf(changes: List<TodoChange>, logs: Collection<TodoLog>, next: String): Map<String, DoneMark> {
    val newest = logs.filter { it.isDated }.maxByOrNull { it.second }
    val last = lastMatchOf(logs)
    val words = changes.mapNotNull { change -> (change.subject as? NextMatch)?.let { change.time to it.match } }

    fun isOfNext(change: TodoChange, match: String): Boolean {
        if (newest != null && !change.isOfSameEventAs(newest, isPractice = next == UNNAMED_MATCH)) return false
        if (match == next) return true
        if (!match.startsWith(AFTER) && match != UNNAMED_MATCH) return false
        if (last != null && (!last.isDated || change.seen == null || change.seen < last.second)) return false
        val said = words.filter { it.first > change.time }
        return said.isNotEmpty() && said.all { it.second == next }
    }

    val ticks = HashMap<String, DoneMark>()
    for (change in changes) {
        val check = change.subject as? Check ?: continue
        if (change.deed is TodoDeed.Assign || !isOfNext(change, check.match)) continue
        val mark = change.mark()
        if (mark == null) ticks -= check.text else ticks[check.text] = mark
    }
    return ticks
}

/** Returns whether this change was made at the event of [newest], and also after it if [isPractice]. */
private fun TodoChange.isOfSameEventAs(newest: TodoLog, isPractice: Boolean): Boolean {
    if (event != null && newest.match.event != null && event != newest.match.event) return false
    if (seen == null) return true
    return newest.second - seen <= LONGEST_EVENT && !(isPractice && seen < newest.second)
}
