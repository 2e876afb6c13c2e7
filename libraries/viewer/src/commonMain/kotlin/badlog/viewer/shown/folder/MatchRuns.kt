package badlog.viewer.shown.folder

import badlog.signals.match.MatchOfLog
import badlog.viewer.catalog.ListedLog
import kotlin.math.abs

/**
 * The logs of one run of a match, such as the robot's and the Driver Station's; or one log without a match.
 *
 * @property logs the logs.
 */
class MatchRun<E : ListedLog>(val logs: List<E>) {
    /**
     * The log with the worst finding; of several, the one with the most samples, usually the robot's. A gray one only if all are gray.
     */
    val worst: E by lazy { logs.maxWith(compareBy({ !it.isGray }, { it.found?.worst }, { it.summary.samples }, { it.modified })) }

    /** The time when the last of the logs began, in s since 1970. */
    val second: Long get() = logs.maxOf { it.summary.date.second }
}

/** Returns [logs] grouped by run, the latest run first. A replayed match, or one with the same number at another event, is another run. */
fun <E : ListedLog> runsOf(logs: List<E>): List<MatchRun<E>> {
    val (ofMatches, others) = logs.partition { it.summary.match.match != null }
    val runs = ofMatches.groupBy { it.summary.match.type to it.summary.match.number }.values.flatMap(::runsOfMatch)
    val all = (runs + others.map(::listOf)).map(::MatchRun)
    return all.sortedWith(compareByDescending<MatchRun<E>> { it.second }.thenByDescending { it.worst.modified })
}

/** Returns the runs in [logs], which all have the type and the number of one match. */
private fun <E : ListedLog> runsOfMatch(logs: List<E>): List<List<E>> {
    val runs = ArrayList<ArrayList<E>>()
    for (log in logs.sortedBy { it.summary.date.second }) {
        val same = runs.lastOrNull { isOfSameRun(it.last(), log) }
        if (same == null) runs += arrayListOf(log) else same += log
    }
    return runs
}

/** Returns whether [one] and [other] are of the same match, and of the same run of it. */
fun isOfSameRun(one: ListedLog, other: ListedLog): Boolean {
    val isOfSameMatch = isOfSameMatch(one.summary.match, other.summary.match)
    return isOfSameMatch && abs(one.summary.date.second - other.summary.date.second) < LONGEST_RUN
}

/** Returns whether [one] and [other] are the same match. An unknown event counts as the same. */
fun isOfSameMatch(one: MatchOfLog, other: MatchOfLog): Boolean {
    if (one.match == null || one.type != other.type || one.number != other.number) return false
    return one.event == null || other.event == null || one.event == other.event
}

/**
 * The maximum time between two logs of a run, in s. A robot is switched on long before its match, and no match is played twice within this
 * time.
 */
internal const val LONGEST_RUN = 3600L
