package badlog.viewer.layout

import androidx.compose.runtime.Composable
import androidx.compose.ui.input.key.Key
import badlog.viewer.app.Command
import badlog.viewer.app.KeyPress
import badlog.viewer.app.Viewer
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
