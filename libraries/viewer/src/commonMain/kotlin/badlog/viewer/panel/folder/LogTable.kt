package badlog.viewer.panel.folder

import badlog.core.recording.Severity
import badlog.viewer.catalog.ListedLog
import badlog.viewer.panel.Check
import badlog.viewer.panel.Entry
import badlog.viewer.panel.EntryCell
import badlog.viewer.panel.EntryColumn
import badlog.viewer.panel.EntryGroup
import badlog.viewer.panel.EntryTable
import badlog.viewer.shown.folder.DAY_END
import badlog.viewer.shown.folder.Listing
import badlog.viewer.shown.folder.LogColumn
import badlog.viewer.shown.folder.MatchRun
import badlog.viewer.shown.folder.foundLines
import badlog.viewer.shown.folder.isNearBrownout
import badlog.viewer.shown.folder.problemSentence
import badlog.viewer.shown.folder.problemSeverity
import badlog.viewer.shown.folder.shortFileName
import badlog.viewer.state.FolderAction
import badlog.viewer.text.countText

/**
 * Returns the listed logs as a table with a row for each match. Columns that are empty for all logs are left out.
 *
 * @param checked the paths of the logs to compare.
 * @param limit the maximum number of rows.
 */
fun <E : ListedLog> logTable(listing: Listing<E>, checked: Set<String>, limit: Int = Int.MAX_VALUE): EntryTable {
    val columns = LogColumn.entries.filter { column -> listing.entries.any { listing.cellOf(it, column) != null } }
    var left = limit
    val groups = listing.rows.groupBy(listing::groupOf).map { (title, runs) ->
        val rows = runs.take(left).map { rowOf(listing, it, columns, checked) }
        left -= rows.size
        EntryGroup(title, countText(runs.sumOf { it.logs.size }, "log"), rows)
    }
    val titles = columns.map {
        EntryColumn(it.name, it.title, it.isNumber, if (it == listing.column) listing.isDescending else null, FolderAction.Sort(it))
    }
    return EntryTable("log-table", "Logs", titles, groups.filter { it.rows.isNotEmpty() })
}

private fun <E : ListedLog> rowOf(listing: Listing<E>, run: MatchRun<E>, columns: List<LogColumn>, checked: Set<String>): Entry {
    val worst = run.worst
    // Readable logs are first, so that their check boxes stand beside their files.
    val logs = run.logs.sortedWith(compareByDescending<E> { it === worst }.thenByDescending { it.isReadable })
    val named = logs.firstOrNull { it.summary.match.event != null } ?: worst
    return Entry(
        worst.path,
        "Log ${worst.fileName}",
        logs.filter { it.isReadable }.map { Check("Compare ${it.fileName}", it.path in checked, FolderAction.Check(it.path)) },
        columns.map { column ->
            when (column) {
                LogColumn.MATCH -> listOf(listing.titleCell(named, worst))
                LogColumn.FILE -> logs.mapNotNull { listing.cellOf(it, column) }
                else -> logs.mapNotNull { listing.cellOf(it, column) }.take(1)
            }
        },
        FolderAction.Open(worst.path, showsFinding = false),
        worst.isGray,
    )
}

/** Returns the title of a match, which [named] names; a press opens [log]. */
private fun Listing<*>.titleCell(named: ListedLog, log: ListedLog): EntryCell {
    val open = FolderAction.Open(log.path, showsFinding = false)
    return EntryCell(LogColumn.MATCH.text(named) ?: shortFileName(nameOf(log)), hint = log.path, open = open)
}

private fun Listing<*>.cellOf(log: ListedLog, column: LogColumn): EntryCell? {
    val text = column.text(log)
    val open = FolderAction.Open(log.path, showsFinding = false)
    return when (column) {
        LogColumn.MATCH -> titleCell(log, log)

        LogColumn.FINDINGS -> happened(log, text)

        // Otherwise the file's name is the title.
        LogColumn.FILE -> if (LogColumn.MATCH.has(log)) EntryCell(shortFileName(nameOf(log)), hint = log.path, open = open) else null

        else -> if (text == null) null else cellOf(log, column, text)
    }
}

private fun Listing<*>.cellOf(log: ListedLog, column: LogColumn, text: String): EntryCell = when (column) {
    LogColumn.DATE -> EntryCell(if (this.column == column) text.substringAfter(DAY_END) else text)

    LogColumn.BATTERY -> {
        val share = ((log.summary.batteryMinimum ?: EMPTY) - EMPTY) / (FULL - EMPTY)
        EntryCell(text, if (log.isNearBrownout) Severity.ERROR else null, share = share.coerceIn(0.0, 1.0))
    }

    LogColumn.PROBLEMS -> EntryCell(text, log.problemSeverity, problemSentence(log))

    else -> EntryCell(text)
}

private fun Listing<*>.happened(log: ListedLog, text: String?): EntryCell? {
    val worst = log.found?.worst
    return when {
        log.path in recording -> EntryCell("recording")
        log.isGray -> EntryCell(log.summary.content.saying)
        text == null -> null
        worst == null -> EntryCell(text)
        else -> EntryCell(text, worst, foundLines(log), open = FolderAction.Open(log.path, showsFinding = true))
    }
}

/** The voltage of an empty bar, in V: a roboRIO is hardly ever on below it. */
private const val EMPTY = 5.0

/** The voltage of a full bar, in V. */
private const val FULL = 13.0
