package badlog.viewer.shown.folder

import badlog.viewer.catalog.FindingSummary
import badlog.viewer.catalog.ListedLog

/**
 * The logs for a pit between two matches: of several logs of one match, the one with the worst finding.
 *
 * @property last the log that began last.
 * @property before the logs before it, at most [MAX_BEFORE], the latest first.
 */
class PitLogs<E : ListedLog>(val last: E, val before: List<E>) {
    companion object {
        /** The maximum number of earlier logs, beside each other on a screen that is read from two meters. */
        const val MAX_BEFORE: Int = 3

        /** Returns the pit's logs among [logs]; null if there is nothing to see. */
        fun <E : ListedLog> of(logs: List<E>): PitLogs<E>? {
            val latest = runsOf(logs.filter { it.isReadable && !it.isGray }).map { it.worst }
            return latest.firstOrNull()?.let { PitLogs(it, latest.drop(1).take(MAX_BEFORE)) }
        }
    }
}

/** Returns the verdict on a log in a few words: `Browned out at 1:33`. */
fun verdictText(found: FindingSummary?): String = when {
    found == null -> "The rules are still running"
    found.rules == null -> "The rules could not be run"
    else -> found.verdict?.headline ?: "No errors, no warnings"
}

/** Returns the reason why a pit view of [logs] is empty, as a sentence. [isReading] is true if some may still be read. */
fun pitEmptiness(logs: List<ListedLog>, isReading: Boolean): String = when {
    isReading -> "Reading the first logs…"
    logs.any { it.isReadable } -> "No log of an enabled robot yet."
    else -> "No log yet."
}

/**
 * Returns the known facts of [log]: its date, its length and its lowest battery voltage. For example: `16 Mar 2024, 10:41 · 2:36 · 6.73 V`.
 */
fun pitFacts(log: ListedLog): String = listOfNotNull(LogColumn.DATE.text(log), durationText(log), batteryText(log)).joinToString(" · ")

/**
 * Returns the readable [logs] of robots. Tables of numbers count only if there are no other logs: they may be about anything, and usually
 * only the file's time shows how old they are.
 *
 * @param isOnlyOfLogs returns whether only logs have such a name.
 */
fun <E : ListedLog> logsOfRobots(logs: List<E>, isOnlyOfLogs: (name: String) -> Boolean): List<E> {
    val readable = logs.filter { it.isReadable }
    return readable.filter { isOnlyOfLogs(it.fileName) }.ifEmpty { readable }
}
