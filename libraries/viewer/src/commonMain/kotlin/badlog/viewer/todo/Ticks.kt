package badlog.viewer.todo

/**
 * Returns who ticked off which line of the checklist before the match [next].
 *
 * A tick is for one match: a robot that leaves the pit unchecked because of an earlier tick is worse than one that is checked twice. It is still
 * there if it was made before anybody said which match that is.
 *
 * @param changes all changes, in their order.
 * @param logs the logs of the folder.
 */
internal fun ticksOf(changes: List<TodoChange>, logs: Collection<FoundLog>, next: String): Map<String, DoneMark> {
    val newest = logs.filter { it.isDated }.maxByOrNull { it.second }
    val last = lastMatchOf(logs)
    val words = changes.mapNotNull { change -> (change.subject as? NextMatch)?.let { change.time to it.match } }

    fun isOfNext(change: TodoChange, match: String): Boolean {
        if (newest != null && !change.isOfDaysOf(newest, isPractice = next == SOME_MATCH)) return false
        if (match == next) return true
        if (!match.startsWith(AFTER) && match != SOME_MATCH) return false
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

/** Returns whether this was made at the event of [newest], and in a practice after it. */
private fun TodoChange.isOfDaysOf(newest: FoundLog, isPractice: Boolean): Boolean {
    if (event != null && newest.match.event != null && event != newest.match.event) return false
    if (seen == null) return true
    return newest.second - seen <= LONGEST_EVENT && !(isPractice && seen < newest.second)
}
