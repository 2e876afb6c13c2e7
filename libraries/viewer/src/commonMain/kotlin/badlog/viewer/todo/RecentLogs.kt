package badlog.viewer.todo

import badlog.signals.match.MatchOfLog
import badlog.signals.match.NaturalOrder
import badlog.viewer.shown.folder.LONGEST_RUN
import badlog.viewer.shown.folder.isOfSameMatch
import kotlin.math.abs

/**
 * Returns the [logs] that began since the fourth-to-last match, see [TodoList.RECENT_RUNS]; without any match, the last four logs. Logs
 * without a date belong to their matches. Idle logs should not be in [logs].
 */
fun recentOf(logs: Collection<TodoLog>): List<TodoLog> {
    val known = logs.filter { it.isDated }.ifEmpty { logs }
    val matches = known.filter { it.match.match != null }
    val begins = if (matches.isEmpty()) known.map { it.second } else beginsOfRuns(matches)
    val begin = begins.sortedDescending().take(TodoList.RECENT_RUNS).lastOrNull() ?: return emptyList()
    val recent = known.filter { it.second >= begin }
    // Logs without a date began with their matches.
    val others = (logs - known.toSet()).filter { log -> recent.any { isOfSameMatch(it.match, log.match) } }
    return recent + others
}

/** Returns the start of each run of a match in [logs]. The logs of the robot and of the Driver Station belong to one run. */
private fun beginsOfRuns(logs: List<TodoLog>): List<Long> {
    val runs = ArrayList<ArrayList<TodoLog>>()
    for (ofMatch in logs.groupBy { it.match.match }.values) {
        val before = runs.size
        for (log in ofMatch.sortedBy { it.second }) {
            val same = runs.drop(before).lastOrNull { isOfSameRun(it.last(), log) }
            if (same == null) runs += arrayListOf(log) else same += log
        }
    }
    return runs.map { it.first().second }
}

private fun isOfSameRun(one: TodoLog, other: TodoLog) =
    isOfSameMatch(one.match, other.match) && (abs(one.second - other.second) < LONGEST_RUN || !one.isDated || !other.isDated)

/**
 * Returns the log of the match that was played last; null if [logs] have no match. Logs without a date are ordered by the number of their
 * match.
 */
internal fun lastMatchOf(logs: Collection<TodoLog>): TodoLog? {
    val (dated, others) = logs.filter { it.match.match != null }.partition { it.isDated }
    val last = dated.maxWithOrNull(compareBy<TodoLog> { it.second }.then(BY_NUMBER))
    return (others.filter { last == null || isOfSameEvent(it.match, last.match) } + listOfNotNull(last)).maxWithOrNull(BY_NUMBER)
}

/** Returns whether the numbers of [one] and [other] count the matches of one event. An unknown event counts as the same. */
private fun isOfSameEvent(one: MatchOfLog, other: MatchOfLog) =
    one.type == other.type && (one.event == null || other.event == null || one.event == other.event)

private val BY_NUMBER: Comparator<TodoLog> = compareBy<TodoLog> { log ->
    FIRST_TYPES.indexOf(log.match.type).takeIf { it >= 0 }
        ?: FIRST_TYPES.size
}
    .thenBy(NaturalOrder) { it.match.number.orEmpty() }
    .thenBy { it.name }

/** The types that are played before all others, in this order. */
private val FIRST_TYPES = listOf("Practice", "Qualification")
