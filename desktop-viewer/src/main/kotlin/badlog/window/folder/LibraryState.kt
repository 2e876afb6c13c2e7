package badlog.window.folder

import badlog.catalog.Content
import badlog.catalog.folder.LogEntry
import badlog.core.recording.Severity
import badlog.files.LogName
import badlog.files.NaturalOrder
import badlog.viewer.shown.search.Query
import java.nio.file.Path

/**
 * The folder of logs as the window shows it. Immutable; each transition returns a new one.
 *
 * @property folder the folder; null before one was opened.
 * @property listing its logs, sorted and filtered.
 * @property reading the progress of reading them; null while there is nothing to read.
 * @property passedOver the number of logs skipped because a person stopped reading.
 * @property hasLooked whether the files have been listed.
 * @property trouble why the folder or a part of it cannot be read, as a sentence; null if all is well.
 * @property selected the file selected with the keyboard.
 * @property searchesAsked how often the keyboard requested the search field.
 */
internal data class LibraryState(
    val folder: Path? = null,
    val listing: Listing = Listing(),
    val reading: ReadingProgress? = null,
    val passedOver: Int = 0,
    val hasLooked: Boolean = false,
    val trouble: String? = null,
    val selected: Path? = null,
    val searchesAsked: Int = 0,
) {
    /** Everything known about the folder's files, in no particular order; including files that are not listed. */
    val entries: List<LogEntry> get() = listing.entries

    /** The listed logs, in order. */
    val visible: List<LogEntry> get() = listing.visible

    /**
     * The log that began last, of those that are not idle, or else of all readable ones; null if there are none. A table of
     * numbers counts only if there is no robot's log: it may be of anything, and usually only its file's time shows its age.
     */
    val newest: LogEntry?
        get() {
            val readable = entries.filter { it.isReadable }
            val logs = readable.filter { LogName.of(it.fileName).isOnlyOfLogs }.ifEmpty { readable }
            return logs.filter { !it.isGray }.maxWithOrNull(AGE) ?: logs.maxWithOrNull(AGE)
        }

    /** Whether there is certainly no log to show: no folder is open, or the one that is open has been read and has no logs. */
    val isWithoutLogs: Boolean get() = folder == null || (hasLooked && reading == null && listing.size == 0)

    /** Returns the state for another [folder], about which nothing is known yet, listed like this one. */
    fun opening(folder: Path): LibraryState = LibraryState(
        folder,
        listing.copy(entries = emptyList(), filter = "", onlyErrors = false, folder = folder),
        searchesAsked = searchesAsked,
    )

    /** Returns the same folder with [entries]. */
    fun knowing(entries: List<LogEntry>): LibraryState = copy(listing = listing.copy(entries = entries))

    /** Lists only logs with all words of [filter]. */
    fun filtered(filter: String): LibraryState = copy(listing = listing.copy(filter = filter))

    /** Sorts by [column]; the other way round when that is so already. */
    fun sorted(column: LogColumn): LibraryState = copy(listing = listing.sorted(column))

    /** Hides or shows gray logs. */
    fun hidingEmpty(hides: Boolean): LibraryState = copy(listing = listing.copy(hidesEmpty = hides))

    /** Hides or shows logs in which no rule found an error. */
    fun onlyErrors(isOn: Boolean): LibraryState = copy(listing = listing.copy(onlyErrors = isOn))

    /** Returns the log [steps] below the selected one in the list; the first or last if the list ends. */
    fun stepped(steps: Int): LogEntry? {
        if (visible.isEmpty()) return null
        val at = visible.indexOfFirst { it.file == selected }
        return visible[if (at < 0) (if (steps > 0) 0 else visible.lastIndex) else (at + steps).coerceIn(visible.indices)]
    }

    private companion object {
        val AGE: Comparator<LogEntry> = compareBy({ it.summary.date.second }, { it.source.modified })
    }
}

/** [read] of [total] logs are read. */
internal data class ReadingProgress(val read: Int, val total: Int)

/**
 * Logs, and which of them are listed in which order.
 *
 * @property entries all logs.
 * @property column the column by which they are sorted.
 * @property isDescending whether the largest comes first; missing values always come last.
 * @property filter words that must all be found in a listed log, regardless of case.
 * @property hidesEmpty whether idle logs are hidden.
 * @property onlyErrors whether only logs are listed in which a rule found an error.
 * @property folder their folder, whose own name is not searched.
 */
internal data class Listing(
    val entries: List<LogEntry> = emptyList(),
    val column: LogColumn = LogColumn.DATE,
    val isDescending: Boolean = true,
    val filter: String = "",
    val hidesEmpty: Boolean = false,
    val onlyErrors: Boolean = false,
    val folder: Path? = null,
) {
    /** The listed logs, in order. */
    val visible: List<LogEntry> by lazy {
        val query = Query(filter)
        entries
            .filter { it.summary.content != Content.NO_LOG && !(hidesEmpty && it.isGray) && isFound(it, query) }
            .filter { !onlyErrors || it.found?.worst == Severity.ERROR }
            .sortedWith(order())
    }

    /** The number of logs, listed or not. */
    val size: Int by lazy { entries.count { it.summary.content != Content.NO_LOG } }

    /** Sorted by [column]; the other way round when that is so already. */
    fun sorted(column: LogColumn): Listing = if (column == this.column) {
        copy(isDescending = !isDescending)
    } else {
        copy(column = column, isDescending = column.beginsDescending)
    }

    private fun isFound(entry: LogEntry, query: Query) = query.isEmpty || query.matches(searchText(entry, folder))

    private fun order(): Comparator<LogEntry> {
        val present = if (isDescending) column.order.reversed() else column.order
        return compareBy<LogEntry> { !column.has(it) }
            .then { a, b -> if (column.has(a)) present.compare(a, b) else 0 }
            .thenByDescending { it.summary.date.second }
            .thenByDescending { it.source.modified }
            .thenBy(NaturalOrder) { it.fileName }
            .thenBy { it.file }
    }
}

private fun searchText(entry: LogEntry, folder: Path?): String = buildString {
    for (fact in with(entry.summary.match) { listOf(event, type, number, alliance) }) if (fact != null) append(fact).append('\n')
    for (rule in entry.found?.rules.orEmpty()) append(rule.name).append('\n')
    append(dateText(entry.summary.date)).append('\n').append(entry.summary.date.time).append('\n')
    append(if (folder != null && entry.file.startsWith(folder)) folder.relativize(entry.file) else entry.file)
}
