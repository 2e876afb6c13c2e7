package badlog.viewer.library

import badlog.file.NaturalOrder
import badlog.viewer.library.index.Content
import badlog.viewer.library.index.LogEntry
import badlog.viewer.text.wordsOf
import java.nio.file.Path

/**
 * Logs, and which of them are listed in what order.
 *
 * @property entries all that there are.
 * @property column by what they are sorted.
 * @property isDescending whether the largest comes first; what is missing always comes last.
 * @property filter words that all must be found in a log to have it listed, in whatever case.
 * @property hidesEmpty whether logs in which nothing happened are left out.
 * @property folder where they are; its own name is not searched.
 */
internal data class Listing(
    val entries: List<LogEntry> = emptyList(),
    val column: LogColumn = LogColumn.DATE,
    val isDescending: Boolean = true,
    val filter: String = "",
    val hidesEmpty: Boolean = false,
    val folder: Path? = null,
) {
    /** What is listed, in its order. */
    val visible: List<LogEntry> by lazy {
        val words = wordsOf(filter.lowercase())
        entries
            .filter { it.content != Content.NO_LOG && !(hidesEmpty && it.isGrey) && hasAll(it, words) }
            .sortedWith(order())
    }

    /** How many logs there are, listed or not. */
    val size: Int by lazy { entries.count { it.content != Content.NO_LOG } }

    /** Sorted by [column]; the other way round when that is so already. */
    fun sorted(column: LogColumn): Listing = if (column == this.column) {
        copy(isDescending = !isDescending)
    } else {
        copy(column = column, isDescending = column.beginsDescending)
    }

    private fun hasAll(entry: LogEntry, words: List<String>): Boolean {
        if (words.isEmpty()) return true
        val text = searchText(entry, folder).lowercase()
        return words.all { it in text }
    }

    private fun order(): Comparator<LogEntry> {
        val present = if (isDescending) column.order.reversed() else column.order
        return compareBy<LogEntry> { !column.has(it) }
            .then { a, b -> if (column.has(a)) present.compare(a, b) else 0 }
            .thenByDescending { it.date.second }
            .thenByDescending { it.source.modified }
            .thenBy(NaturalOrder) { it.fileName }
            .thenBy { it.file }
    }
}

private fun searchText(entry: LogEntry, folder: Path?): String = buildString {
    for (fact in with(entry.match) { listOf(event, type, number, alliance) }) if (fact != null) append(fact).append('\n')
    append(dateText(entry.date)).append('\n').append(entry.date.time).append('\n')
    append(if (folder != null && entry.file.startsWith(folder)) folder.relativize(entry.file) else entry.file)
}
