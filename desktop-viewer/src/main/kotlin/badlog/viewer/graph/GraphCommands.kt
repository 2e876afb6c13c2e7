package badlog.viewer.graph

import androidx.compose.ui.input.key.Key
import badlog.viewer.app.Viewer
import badlog.viewer.keyboard.Command
import badlog.viewer.keyboard.KeyPress

/** What the keyboard does with the graphs besides what it does on an exported page. */
internal fun graphCommands(viewer: Viewer): List<Command> = listOf(
    Command("Graphs", "Zoom to the selection", listOf(KeyPress(Key.Z, "Z"))) { zoomToSelection(viewer) },
)
