package badlog.viewer.layout

import androidx.compose.runtime.Composable
import androidx.compose.ui.input.key.Key
import badlog.viewer.app.Viewer
import badlog.viewer.files.askToWrite
import badlog.viewer.files.fileNameOf
import badlog.viewer.files.sayNoLog
import badlog.viewer.keyboard.Command
import badlog.viewer.keyboard.KeyPress
import badlog.viewer.menu.Menu
import badlog.viewer.menu.MenuEntry
import badlog.viewer.theme.Icons

/** The menu that keeps and brings back how the window is arranged. */
@Composable
internal fun LayoutMenu(viewer: Viewer) {
    Menu("Layout", "Layout: the chosen graphs, ranges and panels", Icons.Layout) {
        val why = "Open a log first.".takeIf { viewer.open == null }
        listOf(
            MenuEntry("Standard graphs", "As the attributes in the log want them", why) { showStandardGraphs(viewer) },
            MenuEntry("Save the layout as…", "A file for another folder, or for a team mate", why, SAVE.text) { saveLayout(viewer) },
            MenuEntry("Open a layout…", "What this log lacks is left out", why) { openLayout(viewer) },
        )
    }
}

/** What the keyboard does with layouts. */
internal fun layoutCommands(viewer: Viewer): List<Command> =
    listOf(Command("Layout", "Save the layout as a file", listOf(SAVE)) { saveLayout(viewer) })

private val SAVE = KeyPress(Key.S, "S", ctrl = true)

/** Asks for a file, and writes to it how the window is arranged. */
internal fun saveLayout(viewer: Viewer) {
    val open = viewer.open ?: return sayNoLog(viewer)
    val name = fileNameOf(viewer.library.folder?.fileName?.toString() ?: "badlog")
    val start = viewer.library.folder ?: open.file.parent
    val file = askToWrite(viewer, "Save the layout", start, name, Layout.ENDING) ?: return
    val layout = layoutOf(viewer)
    viewer.tasks.run("Saving the layout", { writeLayout(file, layout) }) { viewer.notices.say("Saved the layout to $file.") }
}

/** Asks for a layout's file, and arranges the window as it says. */
internal fun openLayout(viewer: Viewer) {
    val start = viewer.library.folder ?: viewer.open?.file?.parent
    val file = viewer.files.toRead("Open a layout", start, Layout.ENDING) ?: return
    viewer.tasks.run("Opening ${file.fileName}", { readLayout(file) }) { applyLayout(viewer, it) }
}
