package badlog.window.app

import badlog.catalog.folder.LogEntry
import badlog.catalog.match.MatchMaker
import badlog.window.files.FileChoice
import badlog.window.folder.Library
import badlog.window.log.RecordingLoader
import badlog.window.task.Notices
import java.nio.file.Files
import java.nio.file.Path

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
