package badlog.viewer.shown.folder

import badlog.core.recording.Severity
import badlog.signals.match.NaturalOrder
import badlog.viewer.catalog.Content
import badlog.viewer.catalog.ListedLog
import badlog.viewer.shown.search.Query
import badlog.viewer.text.countOf
import badlog.viewer.text.countText
import badlog.viewer.text.dateText
import badlog.viewer.text.isoText

/**
 * Logs, with the filter and the order of their list.
 *
 * @property entries all logs.
 * @property column the column by which they are sorted.
 * @property isDescending whether the largest is first; missing values are always last.
 * @property filter words that must all occur in a listed log, regardless of case.
 * @property hidesEmpty whether idle logs are hidden.
 * @property onlyErrors whether only logs with an error found by the rules are listed.
 * @property folder the folder of the logs; its own name is not searched.
 * @property recording the paths of the logs that are being written.
 * @property pages the number of badlog's own pages among the files of the folder; they are not listed.
 */
data class Listing<E : ListedLog>(
    val entries: List<E> = emptyList(),
    val column: LogColumn = LogColumn.DATE,
    val isDescending: Boolean = true,
    val filter: String = "",
    val hidesEmpty: Boolean = false,
    val onlyErrors: Boolean = false,
    val folder: String? = null,
    val recording: Set<String> = emptySet(),
    val pages: Int = 0,
) {
    /** The listed logs, in order. */
    val visible: List<E> by lazy {
        val query = Query(filter)
        val (valued, others) = entries
            .filter { it.summary.content != Content.NO_LOG && !(hidesEmpty && it.isGray) && isFound(it, query) }
            .filter { !onlyErrors || it.found?.worst == Severity.ERROR }
            .sortedWith(order())
            .partition(column::has)
        valued + others
    }

    /**
     * The listed logs by match, in the order of the first log of each, under the titles of their groups. The title is a day, if logs are
     * sorted by time, or an event, if by match; empty without groups.
     */
    val groups: Map<String, List<MatchRun<E>>> by lazy {
        val places = HashMap<String, Int>()
        visible.forEachIndexed { i, log -> places[log.path] = i }
        runsOf(visible).sortedBy { run -> run.logs.minOf { places.getValue(it.path) } }.groupBy(::groupOf)
    }

    /** The listed logs by match, in order. */
    val rows: List<MatchRun<E>> by lazy { groups.values.flatten() }

    private fun groupOf(run: MatchRun<*>): String = when (column) {
        LogColumn.DATE -> column.text(run.worst)?.substringBefore(DAY_END) ?: "No date"
        LogColumn.MATCH -> run.logs.firstNotNullOfOrNull { it.summary.match.event } ?: "No event"
        else -> ""
    }

    /** The number of logs, listed or not. */
    val size: Int by lazy { entries.count { it.summary.content != Content.NO_LOG } }

    /** The number of listed logs: `3 of 12 logs`, or `12 logs`; and of pages that are left out. */
    val count: String
        get() = countOf(visible.size, size, "log") + if (pages == 0) "" else " · ${countText(pages, "page")} left out: open one alone"

    /** The reason why the list is empty, although there are logs, as a sentence. */
    val emptiness: String
        get() = when {
            filter.isNotBlank() -> "No log matches “${filter.trim()}”."
            onlyErrors -> noErrors
            else -> "All of these logs are idle."
        }

    private val noErrors: String
        get() {
            val examined = entries.filter { it.isReadable && !it.isGray }
            val open = examined.count { it.found?.rules == null }
            return when (open) {
                0 -> "Rules found no error in any of these logs."
                examined.size -> "Rules have not run over any of these logs."
                else -> "Rules found no error, but have not run over ${countText(open)} of these logs."
            }
        }

    /** Returns the logs sorted by [column]; in the opposite order if they already are. */
    fun sorted(column: LogColumn): Listing<E> = if (column == this.column) {
        copy(isDescending = !isDescending)
    } else {
        copy(column = column, isDescending = column.beginsDescending)
    }

    /** Returns the path of [log] within the folder. */
    fun nameOf(log: ListedLog): String = log.path.removePrefix(folder.orEmpty()).trimStart('/', '\\')

    private fun isFound(entry: E, query: Query) = query.isEmpty || query.matches(searchText(entry))

    private fun searchText(log: E): String = buildString {
        val facts = with(log.summary.match) { listOf(event, type, number, alliance, shortTitle(this)) }
        for (fact in facts) if (fact != null) append(fact).append('\n')
        for (rule in log.found?.rules.orEmpty()) append(rule.name).append('\n')
        append(dateText(log.summary.date.second)).append('\n').append(isoText(log.summary.date.second)).append('\n')
        append(nameOf(log))
    }

    private fun order(): Comparator<E> {
        val ordered: Comparator<in E> = if (isDescending) column.order.reversed() else column.order
        return Comparator<E> { a, b -> ordered.compare(a, b) }
            .thenByDescending { it.summary.date.second }
            .thenByDescending { it.modified }
            .thenBy(NaturalOrder) { it.fileName }
            .thenBy { it.path }
    }
}

/** The end of the day in the text of a date. */
internal const val DAY_END = ", "
