package badlog.viewer.shown.folder

import badlog.viewer.catalog.ListedLog
import badlog.viewer.catalog.LogFound

/**
 * What a pit looks at between two matches.
 *
 * @property last the log that began last.
 * @property before those before it, at most [MOST_BEFORE], the latest first.
 */
class PitLogs<E : ListedLog>(val last: E, val before: List<E>) {
    companion object {
        const val MOST_BEFORE: Int = 3

        /** Returns those of [logs] that a pit looks at: of several logs of one match the one with the worst finding; null if there is nothing to see. */
        fun <E : ListedLog> of(logs: List<E>): PitLogs<E>? {
            val seen = logs.filter { it.isReadable && !it.isGray }
            val latest = seen.groupBy(::matchOrFile).values.map { same -> same.maxWith(compareBy({ it.found?.worst }, { it.modified })) }
                .sortedWith(compareByDescending<E> { it.summary.date.second }.thenByDescending { it.modified })
            return latest.firstOrNull()?.let { PitLogs(it, latest.drop(1).take(MOST_BEFORE)) }
        }
    }
}

/** Returns what is the same for all logs of one match. */
private fun matchOrFile(log: ListedLog): Any = with(log.summary.match) { if (match == null) log.path else Triple(event, type, number) }

/** Returns the verdict on a log in a few words: `Browned out at 1:33`. */
fun verdictText(found: LogFound?): String = when {
    found == null -> "The rules are still running"
    found.rules == null -> "The rules could not be run"
    else -> found.verdict?.headline ?: "No errors, no warnings"
}

/** Returns the paths of those of [logs] of whose match there are others: their names alone do not tell them apart. */
fun sameMatches(logs: List<ListedLog>): Set<String> = logs.filter {
    it.summary.match.match != null
}.groupBy(::matchOrFile).values.filter { it.size > 1 }.flatten().mapTo(HashSet()) { it.path }
