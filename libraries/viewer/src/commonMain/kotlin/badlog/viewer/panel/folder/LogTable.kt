package badlog.viewer.panel.folder

import badlog.core.recording.Severity
import badlog.viewer.catalog.ListedLog
import badlog.viewer.panel.Cell
import badlog.viewer.panel.Check
import badlog.viewer.panel.Column
import badlog.viewer.panel.RowGroup
import badlog.viewer.panel.Table
import badlog.viewer.panel.TableRow
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
fun <E : ListedLog> logTable(listing: Listing<E>, checked: Set<String>, limit: Int = Int.MAX_VALUE): Table {
    val columns = LogColumn.entries.filter { column -> listing.entries.any { listing.cellOf(it, column) != null } }
    var left = limit
    val groups = listing.groups.map { (title, runs) ->
        val rows = runs.take(left).map { matchRow(listing, it, columns, checked) }
        left -= rows.size
        RowGroup(rows, title, countText(runs.sumOf { it.logs.size }, "log"))
    }
    val titles = columns.map {
        val isDescending = if (it == listing.column) listing.isDescending else null
        Column(it.title, "", FolderAction.Sort(it), isDescending, it.isNumber, it.name, isMinor = it in MINOR)
    }
    return Table("logs", titles, groups.filter { it.rows.isNotEmpty() }, "Logs")
}

private fun <E : ListedLog> matchRow(listing: Listing<E>, run: MatchRun<E>, columns: List<LogColumn>, checked: Set<String>): TableRow {
    val worst = run.worst
    // Readable logs are first, so that their check boxes stand beside their files.
    val logs = run.logs.sortedWith(compareByDescending<E> { it === worst }.thenByDescending { it.isReadable })
    val named = logs.firstOrNull { it.summary.match.event != null } ?: worst
    return TableRow(
        "Log ${worst.fileName}",
        columns.map { column ->
            when (column) {
                LogColumn.MATCH -> listOf(listing.titleCell(named, worst))
                LogColumn.FILE -> logs.mapNotNull { listing.cellOf(it, column) }
                else -> ordered(logs, column).firstNotNullOfOrNull { listing.cellOf(it, column) }.let(::listOfNotNull)
            }
        },
        worst.path,
        checks = logs.filter { it.isReadable }.map { Check("Compare ${it.fileName}", it.path in checked, FolderAction.Check(it.path)) },
        open = FolderAction.Open(worst.path, showsFinding = false),
        isMuted = worst.isGray,
    )
}

/** Returns [logs] so that the first one has the value of the match: the lowest or largest number. */
private fun <E : ListedLog> ordered(logs: List<E>, column: LogColumn): List<E> = when {
    !column.isNumber -> logs
    column.beginsDescending -> logs.sortedWith(column.order.reversed())
    else -> logs.sortedWith(column.order)
}

/** Returns the title of a match, which [named] names; a press opens [log]. */
private fun Listing<*>.titleCell(named: ListedLog, log: ListedLog): Cell {
    val open = FolderAction.Open(log.path, showsFinding = false)
    return Cell(LogColumn.MATCH.text(named) ?: shortFileName(nameOf(log)), hint = log.path, open = open)
}

private fun Listing<*>.cellOf(log: ListedLog, column: LogColumn): Cell? {
    val text = column.text(log)
    val open = FolderAction.Open(log.path, showsFinding = false)
    return when (column) {
        LogColumn.MATCH -> titleCell(log, log)

        LogColumn.FINDINGS -> happened(log, text)

        // Otherwise the file's name is the title.
        LogColumn.FILE -> if (LogColumn.MATCH.has(log)) Cell(shortFileName(nameOf(log)), hint = log.path, open = open) else null

        else -> if (text == null) null else cellOf(log, column, text)
    }
}

private fun Listing<*>.cellOf(log: ListedLog, column: LogColumn, text: String): Cell = when (column) {
    LogColumn.DATE -> Cell(if (this.column == column) text.substringAfter(DAY_END) else text)

    LogColumn.BATTERY -> {
        val share = ((log.summary.batteryMinimum ?: EMPTY) - EMPTY) / (FULL - EMPTY)
        Cell(text, severity = if (log.isNearBrownout) Severity.ERROR else null, share = share.coerceIn(0.0, 1.0))
    }

    LogColumn.PROBLEMS -> Cell(text, problemSentence(log), severity = log.problemSeverity)

    else -> Cell(text)
}

private fun Listing<*>.happened(log: ListedLog, text: String?): Cell? {
    val worst = log.found?.worst
    return when {
        log.path in recording -> Cell("recording")
        log.isGray -> Cell(log.summary.content.saying)
        text == null -> null
        worst == null -> Cell(text)
        else -> Cell(text, foundLines(log), open = FolderAction.Open(log.path, showsFinding = true), severity = worst)
    }
}

private val MINOR = setOf(LogColumn.ALLIANCE, LogColumn.SAMPLES, LogColumn.SIZE)

/** The voltage of an empty bar, in V: a roboRIO is hardly ever on below it. */
private const val EMPTY = 5.0

/** The voltage of a full bar, in V. */
private const val FULL = 13.0
