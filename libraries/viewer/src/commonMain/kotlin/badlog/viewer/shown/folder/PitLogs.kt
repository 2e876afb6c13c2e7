package badlog.viewer.shown.folder

import badlog.viewer.catalog.ListedLog
import badlog.viewer.catalog.LogFound

/**
 * What a pit looks at between two matches: of several logs of one match, the one with the worst finding.
 *
 * @property last the log that began last.
 * @property before those before it, at most [MOST_BEFORE], the latest first.
 */
class PitLogs<E : ListedLog>(val last: E, val before: List<E>) {
    companion object {
        /** As many logs as are beside each other on a screen that is read from two meters. */
        const val MOST_BEFORE: Int = 3

        /** Returns those of [logs] that a pit looks at; null if there is nothing to see. */
        fun <E : ListedLog> of(logs: List<E>): PitLogs<E>? {
            val latest = runsOf(logs.filter { it.isReadable && !it.isGray }).map { it.worst }
            return latest.firstOrNull()?.let { PitLogs(it, latest.drop(1).take(MOST_BEFORE)) }
        }
    }
}

/** Returns the verdict on a log in a few words: `Browned out at 1:33`. */
fun verdictText(found: LogFound?): String = when {
    found == null -> "The rules are still running"
    found.rules == null -> "The rules could not be run"
    else -> found.verdict?.headline ?: "No errors, no warnings"
}

/** Returns the paths of those of [logs] of whose run there are others: the match alone does not tell them apart. */
fun sameMatches(logs: List<ListedLog>): Set<String> =
    runsOf(logs).filter { it.logs.size > 1 }.flatMapTo(HashSet()) { run -> run.logs.map { it.path } }

/**
 * Returns those of [logs] that are readable and of robots. Tables of numbers count only if there is no other log: they may be of anything, and
 * usually only the file's time shows how old they are.
 *
 * @param isOnlyOfLogs returns whether only logs have such a name.
 */
fun <E : ListedLog> logsOfRobots(logs: List<E>, isOnlyOfLogs: (name: String) -> Boolean): List<E> {
    val readable = logs.filter { it.isReadable }
    return readable.filter { isOnlyOfLogs(it.fileName) }.ifEmpty { readable }
}
