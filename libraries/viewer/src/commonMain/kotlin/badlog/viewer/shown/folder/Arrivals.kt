package badlog.viewer.shown.folder

import badlog.viewer.catalog.FindingSummary
import badlog.viewer.catalog.ListedLog
import badlog.viewer.text.countText

/**
 * The logs that have arrived in a folder since it was opened: new files, and files that have grown. They wait until a person has dealt
 * with them. A log arrives once, when it is complete and the rules have run over it. Immutable; each transition returns a new one.
 *
 * @property waiting the logs that are still waiting, in the order of arrival.
 */
class Arrivals<E : ListedLog> private constructor(private val known: Map<String, Long>?, val waiting: List<E>) {
    constructor() : this(null, emptyList())

    /** Whether the earlier files are known. */
    val hasBegun: Boolean get() = known != null

    /** The latest match with a waiting log; null if no log waits. */
    val latest: MatchRun<E>? get() = waiting.lastOrNull()?.let { last -> MatchRun(waiting.filter { it === last || isOfSameRun(it, last) }) }

    /** Returns the arrivals once the earlier files are known; [sizes] has their sizes by path. */
    fun begun(sizes: Map<String, Long>): Arrivals<E> = Arrivals(sizes, waiting)

    /** Returns whether [log] is new or has another size than before, and has not arrived yet. */
    fun isNew(log: E): Boolean = known != null && known[log.path] != log.size && known[log.path] != ARRIVED

    /** Returns the arrivals when the folder has [entries]. */
    fun withEntries(entries: List<E>): Arrivals<E> {
        if (known == null) return this
        val present = entries.associateBy { it.path }
        val arrived = entries.filter { it.found != null && it.isReadable && !it.isGray && isNew(it) }
        // Removed logs are gone. A log that grows again stays as it was until the rules have run again.
        val before = waiting.mapNotNull { old -> present[old.path]?.let { if (it.found == null) old else it } }
        if (arrived.isEmpty() && before == waiting) return this
        return Arrivals(known + arrived.associate { it.path to ARRIVED }, before + arrived.sortedBy { it.modified })
    }

    /** Returns the arrivals without any waiting log, after a person has dealt with them. */
    fun dealtWith(): Arrivals<E> = if (waiting.isEmpty()) this else Arrivals(known, emptyList())

    /** Returns the arrivals without the log at [path], which a person has opened. */
    fun without(path: String): Arrivals<E> {
        val left = waiting.filter { it.path != path }
        return if (left.size == waiting.size) this else Arrivals(known, left)
    }
}

/**
 * Returns a message such as `Qualification 78 arrived: 1 error, 2 warnings. Browned out at 1:33.` The number of [others] that arrived, too,
 * follows.
 */
fun arrivalText(log: ListedLog, others: Int = 0): String {
    val rest = if (others == 0) "" else " ${countText(others, "other log", "other logs")} arrived, too."
    return "${log.title} arrived: ${outcomeOf(log.found)}$rest"
}

private fun outcomeOf(found: FindingSummary?): String {
    if (found?.rules == null) return "the rules could not be run over it."
    val verdict = found.verdict ?: return "no errors, no warnings."
    val counts = listOf(verdict.errors to "error", verdict.warnings to "warning").filter { it.first > 0 }
    return counts.joinToString { (count, what) -> countText(count, what) } + ". ${verdict.headline}."
}

/** The stand-in for the size of a file that has arrived, and does not arrive again. */
private const val ARRIVED = -1L
