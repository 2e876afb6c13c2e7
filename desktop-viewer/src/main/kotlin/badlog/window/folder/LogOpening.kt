package badlog.window.folder

import badlog.catalog.folder.LogEntry
import badlog.catalog.match.MatchMaker
import badlog.window.files.FileChoice
import badlog.window.log.RecordingLoader
import badlog.window.task.Notices
import java.nio.file.Files
import java.nio.file.Path

/**
 * A person's actions on the logs of a folder, besides changing the list.
 *
 * @property open shows a log.
 * @property openInGraphs shows a log, and the graphs instead of the table.
 * @property openFindings shows a log in the graphs, its findings beside them, and the worst finding.
 * @property check starts or stops comparing with the log in a file.
 * @property opener opens folders and files.
 * @property closeLog returns the function that closes the open log; null if it stays open until another replaces it, as a folder's log.
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
    val opener: LogOpener,
    val closeLog: () -> (() -> Unit)?,
    val toggleTable: () -> Unit,
    val toggleCharts: () -> Unit,
    val togglePit: () -> Unit,
    val toggleBatteries: () -> Unit,
    val toggleTodo: () -> Unit,
    val showGraphs: () -> Unit,
)

/** The logs in the graphs: the [open] one, if any, and the [checked] ones that are compared with it. */
internal class ShownLogs(val open: Path?, val checked: List<Path>)

/** Opens logs and folders that a person names, selects or drops. */
internal class LogOpener(
    private val library: Library,
    private val loader: RecordingLoader,
    private val files: FileChoice,
    private val notices: Notices,
) {
    /** Shows the log of [entry], or says why it cannot be shown. */
    fun open(entry: LogEntry) {
        library.select(entry.file)
        if (entry.summary.trouble == null) loader.open(entry.file) else notices.complain("${entry.fileName}: ${entry.summary.trouble}")
    }

    /** Shows the log [steps] below the selected one in the list. */
    fun step(steps: Int) {
        val next = library.state.stepped(steps) ?: return
        if (next.file != library.state.selected) open(next)
    }

    /**
     * Opens the first folder of [paths], or otherwise the first log, with its folder if none is open yet. Of a folder with a `match.json`,
     * it also opens the match.
     */
    fun openNamed(paths: List<Path>) {
        val folder = paths.firstOrNull { Files.isDirectory(it) }
        if (folder != null) {
            val match = MatchMaker.manifestIn(folder)
            library.open(folder, showsNewest = match == null)
            match?.let(loader::open)
            return
        }
        val file = paths.firstOrNull() ?: return
        if (library.state.folder == null) file.parent?.let { library.open(it, showsNewest = false) }
        loader.open(file)
    }

    /** Asks for a folder, under [title], and opens it. */
    fun askForFolder(title: String = "Open a folder of logs") {
        files.folder(title, library.state.folder)?.let { library.open(it) }
    }

    /** Asks for a log and opens it, and its folder if none is open yet. */
    fun askForLog() {
        files.toRead("Open a log", library.state.folder)?.let { openNamed(listOf(it)) }
    }
}
