package badlog.viewer.library

import badlog.plot.Span
import badlog.viewer.library.index.LogEntry
import badlog.viewer.library.index.TopicSummary

/**
 * Which topic each of [entries] previews: the one called [name], or else its battery's voltage. All are drawn to one scale, so
 * that they can be compared at a glance.
 */
internal class Previews(entries: List<LogEntry>, private val name: String?) {
    /** The part of y that is drawn; null when there is nothing to draw. */
    val range: Span? = commonRange(entries.mapNotNull(::of).filter { it.statistics.count > 0 })

    /** What [entry] previews; null when it has no such topic. */
    fun of(entry: LogEntry): TopicSummary? = (name ?: entry.batteryTopic)?.let(entry::topic)
}

/** Wide enough for nearly all of [topics]: a single log with a wild value must not flatten the others. */
private fun commonRange(topics: List<TopicSummary>): Span? {
    if (topics.isEmpty()) return null
    val lows = topics.map { it.statistics.min }.sorted()
    val highs = topics.map { it.statistics.max }.sorted()
    val outliers = topics.size / 20
    return Span(lows[outliers], maxOf(lows[outliers], highs[highs.lastIndex - outliers]))
}
