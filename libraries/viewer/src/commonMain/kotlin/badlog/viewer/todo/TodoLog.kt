package badlog.viewer.todo

import badlog.core.recording.Severity
import badlog.rules.Finding
import badlog.signals.match.MatchOfLog
import badlog.signals.match.NaturalOrder
import badlog.viewer.catalog.DateSource
import badlog.viewer.catalog.LogDate
import badlog.viewer.shown.folder.LONGEST_RUN
import badlog.viewer.shown.folder.isOfSameMatch
import kotlin.math.abs

/**
 * A log of the folder with the findings of the rules.
 *
 * @property name the name of the log's file.
 * @property match the match in which the log was recorded.
 * @property second the time when the log began, in s since 1970 on the clock of the logs.
 * @property faults the findings.
 * @property isDated whether [second] can be compared with the clocks of other logs. The time of a file differs on each laptop, and a
 *   robot's clock in the future does not show which log is earlier.
 */
data class TodoLog(val name: String, val match: MatchOfLog, val second: Long, val faults: List<FoundFault>, val isDated: Boolean = true) {
    /** The displayed name: the match if known, otherwise the name of the file. */
    val title: String get() = match.match ?: name

    companion object {
        /**
         * Returns a log that began at [date] and has these [faults].
         *
         * @param now the local time of the wall clock here, in s since 1970 on that clock.
         */
        fun of(name: String, match: MatchOfLog, date: LogDate, now: Long, faults: List<FoundFault> = emptyList()): TodoLog {
            val isFuture = now > FIRST_RELEASE && date.second > now + DAY
            return TodoLog(name, match, date.second, faults, date.source != DateSource.FILE_TIME && !isFuture)
        }

        /** A day, in s: the time zone of a log may differ. */
        private const val DAY = 86_400L

        /** The beginning of 2025: a clock before it is wrong, and cannot recognize a date in the future. */
        private const val FIRST_RELEASE = 1_735_689_600L
    }
}

/**
 * A finding of a rule in a log.
 *
 * @property task the to-do item of the finding.
 * @property text the text of the finding, a sentence.
 */
data class FoundFault(val task: FaultTask, val severity: Severity, val text: String) {
    companion object {
        /** Returns [finding] as a possible item of a list. */
        fun of(finding: Finding): FoundFault = FoundFault(taskOf(finding), finding.severity, finding.text)
    }
}

/**
 * Returns the to-do item of [finding]. It is the same for the same fault in another match, and in the Driver Station's log, where topics
 * have other names.
 */
fun taskOf(finding: Finding): FaultTask = FaultTask(finding.rule, finding.topic.takeIf { finding.isForEach })

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
