package badlog.viewer.panel.folder

import badlog.core.analysis.Span
import badlog.viewer.catalog.ListedLog
import badlog.viewer.catalog.TopicSummary
import badlog.viewer.panel.Entry
import badlog.viewer.panel.EntryCell
import badlog.viewer.panel.EntryColumn
import badlog.viewer.panel.EntryGroup
import badlog.viewer.panel.EntryTable
import badlog.viewer.panel.Preview
import badlog.viewer.shown.folder.LogColumn

/**
 * Returns this table of [logs] with the preview of each: the topic called [name], or otherwise the battery voltage. All are drawn to the
 * same scale, so that they can be compared at a glance.
 */
fun EntryTable.withPreviews(logs: List<ListedLog>, name: String?): EntryTable {
    val topics = logs.associate { log -> log.path to (name ?: log.summary.batteryTopic)?.let(log.summary::topic) }
    val range = commonRange(topics.values.filterNotNull().filter { it.statistics.count > 0 }) ?: return this
    val at = columns.indexOfLast { LogColumn.valueOf(it.key) <= LogColumn.BATTERY } + 1
    fun cells(row: Entry) = listOfNotNull(topics[row.key]?.let { EntryCell("", preview = Preview(it, range)) })
    val rows = groups.map { group ->
        EntryGroup(
            group.title,
            group.count,
            group.rows.map {
                Entry(it.key, it.name, it.checks, it.cells.with(at, cells(it)), it.open, it.isMuted)
            },
        )
    }
    val title = EntryColumn(PREVIEW, name ?: "Battery voltage", isNumber = false, isDescending = null, sort = null)
    return EntryTable(key, this.name, columns.with(at, title), rows)
}

/** The key of the column with the previews. */
const val PREVIEW: String = "PREVIEW"

private fun <T> List<T>.with(at: Int, item: T) = take(at) + listOf(item) + drop(at)

/** Returns a range for nearly all values of [topics]. A single log with a wild value must not flatten the others. */
private fun commonRange(topics: List<TopicSummary>): Span? {
    if (topics.isEmpty()) return null
    val lows = topics.map { it.statistics.min }.sorted()
    val highs = topics.map { it.statistics.max }.sorted()
    val outliers = topics.size / 20
    return Span(lows[outliers], maxOf(lows[outliers], highs[highs.lastIndex - outliers]))
}
