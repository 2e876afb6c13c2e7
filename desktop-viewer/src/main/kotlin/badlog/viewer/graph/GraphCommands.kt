package badlog.viewer.graph

import androidx.compose.ui.input.key.Key
import badlog.viewer.keyboard.Command
import badlog.viewer.keyboard.KeyPress
import badlog.viewer.view.AxisView

/** What the keyboard does with the graphs besides what it does on an exported page. */
internal fun graphCommands(view: AxisView): List<Command> = listOf(
    Command("Graphs", "Zoom to the selection", listOf(KeyPress(Key.Z, "Z"))) { zoomToSelection(view) },
)
