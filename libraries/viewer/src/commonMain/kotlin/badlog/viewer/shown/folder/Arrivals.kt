package badlog.viewer.shown.folder

import badlog.core.recording.Severity
import badlog.viewer.catalog.ListedLog
import badlog.viewer.text.countText

/**
 * The logs that have come into a folder since somebody opened it, until they are dealt with: new files, and files that have grown since. A log
 * arrives when it is complete and the rules have run over it. Immutable; each transition returns a new one.
 *
 * @property waiting those not dealt with, in the order of arrival.
 */
class Arrivals<E : ListedLog> private constructor(private val known: Map<String, Long>?, val waiting: List<E>) {
    constructor() : this(null, emptyList())

    /** The log that arrived last; null if all are dealt with. */
    val latest: E? get() = waiting.lastOrNull()

    /** Returns what has arrived when the folder holds [entries]; those of the first call were there before. */
    fun knowing(entries: List<E>): Arrivals<E> {
        if (known == null) return Arrivals(entries.associate { it.path to it.size }, emptyList())
        val present = entries.associateBy { it.path }
        val arrived = entries.filter { it.found != null && it.isReadable && !it.isGray && known[it.path] != it.size }
        if (arrived.isEmpty() && waiting.all { present[it.path] === it }) return this
        // What was removed is gone, and rules may have run again.
        val before = waiting.mapNotNull { present[it.path] }.filter { it !in arrived }
        return Arrivals(known + arrived.associate { it.path to it.size }, before + arrived.sortedBy { it.modified })
    }

    /** Whether the logs that were there before are known. */
    val hasBegun: Boolean get() = known != null

    /** Returns the same without any that wait: somebody has dealt with them. */
    fun dealtWith(): Arrivals<E> = if (waiting.isEmpty()) this else Arrivals(known, emptyList())

    /** Returns the same without the log at [path], which somebody has opened. */
    fun without(path: String): Arrivals<E> = if (waiting.none { it.path == path }) {
        this
    } else {
        Arrivals(
            known,
            waiting.filter {
                it.path !=
                    path
            },
        )
    }
}

/** Returns `Qualification 78 arrived: 1 error, 2 warnings. Browned out at 1:33.`, and how many [others] did besides. */
fun arrivalText(log: ListedLog, others: Int = 0): String {
    val found = log.found
    val counts = Severity.entries.reversed().filter { it != Severity.NOTE }.mapNotNull { severity ->
        found?.count(severity)?.takeIf { it > 0 }?.let { countText(it, severity.name.lowercase()) }
    }
    val outcome = when {
        found?.rules == null -> "the rules could not be run over it"
        counts.isEmpty() -> "no errors, no warnings"
        else -> counts.joinToString(", ")
    }
    val headline = found?.verdict?.let { " ${it.headline}." }.orEmpty()
    val rest = if (others == 0) "" else " ${countText(others, "other log", "other logs")} arrived before."
    return "${log.title} arrived: $outcome.$headline$rest"
}
