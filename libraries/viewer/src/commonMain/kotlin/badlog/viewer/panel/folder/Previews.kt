package badlog.viewer.panel.folder

import badlog.core.analysis.Span
import badlog.viewer.catalog.ListedLog
import badlog.viewer.catalog.TopicSummary
import badlog.viewer.panel.Cell
import badlog.viewer.panel.Column
import badlog.viewer.panel.Preview
import badlog.viewer.panel.RowGroup
import badlog.viewer.panel.Table
import badlog.viewer.panel.TableRow
import badlog.viewer.shown.folder.LogColumn

/**
 * Returns this table of [logs] with the preview of each: the topic called [name], or otherwise the battery voltage. All are drawn to the
 * same scale, so that they can be compared at a glance.
 */
fun Table.withPreviews(logs: List<ListedLog>, name: String?): Table {
    val topics = logs.associate { log -> log.path to (name ?: log.summary.batteryTopic)?.let(log.summary::topic) }
    val range = commonRange(topics.values.filterNotNull().filter { it.statistics.count > 0 }) ?: return this
    val at = columns.indexOfLast { LogColumn.valueOf(it.key) <= LogColumn.BATTERY } + 1
    fun cells(row: TableRow) = listOfNotNull(topics[row.key]?.let { Cell("", preview = Preview(it, range)) })
    val rows = groups.map { group ->
        RowGroup(group.rows.map { it.copy(cells = it.cells.with(at, cells(it))) }, group.title, group.count)
    }
    return Table(key, columns.with(at, Column(name ?: "Voltage", key = PREVIEW)), rows, this.name)
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
