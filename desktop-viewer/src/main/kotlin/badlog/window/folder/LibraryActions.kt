package badlog.window.folder

import badlog.catalog.folder.LogEntry
import java.nio.file.Path

/**
 * A person's actions on the logs of a folder, besides changing the list.
 *
 * @property open shows a log.
 * @property openInGraphs shows a log, and the graphs instead of the table.
 * @property openFindings shows a log in the graphs, its findings beside them, and the worst finding.
 * @property check starts or stops comparing with the log in a file.
 * @property askForFolder asks for another folder and opens it.
 * @property askForLog asks for a log and opens it.
 * @property canCloseLog returns whether the open log can be closed: a folder's log stays open until another replaces it.
 * @property closeLog closes the open log.
 * @property toggleTable shows all logs as a table, or the graphs again.
 * @property toggleCharts shows charts of the listed logs, or the graphs again.
 * @property togglePit shows the last logs in large letters, or the graphs again.
 * @property toggleBatteries shows the team's batteries, or the graphs again.
 * @property toggleTodo shows the team's to-do list, or the graphs again.
 * @property showGraphs shows the graphs again.
 */
internal class LibraryActions(
    val open: (LogEntry) -> Unit,
    val openInGraphs: (LogEntry) -> Unit,
    val openFindings: (LogEntry) -> Unit,
    val check: (Path) -> Unit,
    val askForFolder: () -> Unit,
    val askForLog: () -> Unit,
    val canCloseLog: () -> Boolean,
    val closeLog: () -> Unit,
    val toggleTable: () -> Unit,
    val toggleCharts: () -> Unit,
    val togglePit: () -> Unit,
    val toggleBatteries: () -> Unit,
    val toggleTodo: () -> Unit,
    val showGraphs: () -> Unit,
)

/** The logs in the graphs: the [open] one, if any, and the [checked] ones that are compared with it. */
internal class ShownLogs(val open: Path?, val checked: List<Path>)
