package badlog.viewer.library

import androidx.compose.ui.input.key.Key
import badlog.viewer.app.Command
import badlog.viewer.app.FrontPart
import badlog.viewer.app.KeyPress
import badlog.viewer.app.MainView
import badlog.viewer.app.Viewer

/** What the keyboard does with the folder of logs. */
internal fun libraryCommands(viewer: Viewer): List<Command> = listOf(
    Command(GROUP, "Open a folder of logs", listOf(KeyPress(Key.O, "O", ctrl = true))) { chooseFolder(viewer) },
    Command(GROUP, "Open a log", listOf(KeyPress(Key.O, "O", ctrl = true, shift = true))) { chooseFile(viewer) },
    Command(GROUP, "Open the previous log of the list", listOf(KeyPress(Key.PageUp, "Page up"))) { viewer.openStepped(-1) },
    Command(GROUP, "Open the next log of the list", listOf(KeyPress(Key.PageDown, "Page down"))) { viewer.openStepped(1) },
    Command(GROUP, "Search the logs", listOf(KeyPress(Key.Slash, "/"))) { viewer.askForSearch() },
    Command(GROUP, "All logs as a table, and back", listOf(KeyPress(Key.T, "T"))) { viewer.toggleTable() },
)

/** Puts the keyboard into the search field of the logs. */
internal fun Viewer.askForSearch() {
    if (panels.main != MainView.LOGS) panels = panels.copy(library = true, front = FrontPart.LOGS)
    library = library.copy(searchesAsked = library.searchesAsked + 1)
}

/** Shows the table of logs, or the graphs again. */
internal fun Viewer.toggleTable() {
    panels = panels.toggled(MainView.LOGS)
}

private const val GROUP = "Logs"
