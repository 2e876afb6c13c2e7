package badlog.window.app

import androidx.compose.runtime.snapshotFlow
import badlog.catalog.match.MatchMaker
import badlog.files.missingSentence
import badlog.window.folder.Library
import badlog.window.layout.LayoutStore
import badlog.window.log.RecordingLoader
import badlog.window.settings.Settings
import badlog.window.sidebar.MainView
import badlog.window.sidebar.WindowPanels
import badlog.window.task.Notices
import kotlinx.coroutines.flow.first
import java.awt.Desktop
import java.nio.file.Files
import java.nio.file.InvalidPathException
import java.nio.file.Path

/**
 * The folder and the log that the window opens at its start.
 *
 * @property folder the folder with the listed logs, or null.
 * @property file the log it shows, or the `match.json` in [folder]; null for the newest log of [folder].
 * @property complaint the reason why it differs from the request, as a sentence, or null.
 * @property isPit whether it begins with the pit view.
 */
internal data class StartPlace(val folder: Path?, val file: Path?, val complaint: String?, val isPit: Boolean = false) {
    companion object {
        /** The argument that starts the window with the pit view. It can be given in addition to the folder. */
        const val PIT: String = "--pit"

        /** Returns the start for [arguments], see the other function. If they include [PIT], it begins with the pit view. */
        fun of(arguments: Array<String>, settings: Settings, samples: Path?): StartPlace =
            of(arguments.firstOrNull { it != PIT }, settings, samples).copy(isPit = PIT in arguments)

        /**
         * Returns the start for [argument], a folder or a file; it complains about a name that does not exist. Without [argument], the
         * folder is the last one that still exists, or otherwise [samples].
         */
        fun of(argument: String?, settings: Settings, samples: Path?): StartPlace {
            val remembered = settings.recentFolders.mapNotNull(::pathNamed) + listOfNotNull(samples)
            val folder = remembered.firstOrNull { Files.isDirectory(it) }
            if (argument == null) return StartPlace(folder, null, null)
            val named = pathNamed(argument)?.toAbsolutePath()?.normalize()
            return when {
                named == null -> StartPlace(folder, null, "“$argument” cannot be the name of a file; check the spelling.")
                Files.isDirectory(named) -> StartPlace(named, MatchMaker.manifestIn(named), null)
                Files.exists(named) -> StartPlace(named.parent, named, null)
                else -> StartPlace(folder, null, missingSentence("$named"))
            }
        }
    }
}

/** Returns the path called [name]. Returns null if the system does not allow such names, as with a question mark on Windows. */
private fun pathNamed(name: String): Path? = try {
    Path.of(name)
} catch (_: InvalidPathException) {
    null
}

/** Opens [start] when the window appears. For a folder, opens the log that was last open there, until a newer one is found. */
internal suspend fun openFirst(
    start: StartPlace,
    library: Library,
    layouts: LayoutStore,
    newest: NewestLog,
    loader: RecordingLoader,
    notices: Notices,
) {
    start.complaint?.let { notices.complain(it) }
    start.folder?.let { library.open(it, showsNewest = start.file == null) }
    if (start.file != null) return loader.open(start.file)
    newest.beginWith { start.folder?.let { layouts.lastOpenIn(it) } }
}

/** Shows the pit view as soon as the folder is listed, and its last layout is restored. */
internal suspend fun beginWithPit(library: Library, layouts: LayoutStore, panels: WindowPanels) {
    if (library.state.folder == null) return
    snapshotFlow { library.state.hasLooked && layouts.folder == library.state.folder }.first { it }
    panels.change { copy(main = MainView.PIT) }
}

/** Opens double-clicked files on a Mac, which sends them as a message to the running program. */
internal fun opensClickedFiles(loader: RecordingLoader) {
    if (!Desktop.isDesktopSupported()) return
    val desktop = Desktop.getDesktop()
    if (!desktop.isSupported(Desktop.Action.APP_OPEN_FILE)) return
    desktop.setOpenFileHandler { event -> event.files.firstOrNull()?.let { loader.open(it.toPath()) } }
}
