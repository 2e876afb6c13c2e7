package badlog.window.graph.scene

import androidx.compose.ui.input.key.Key
import badlog.window.log.AxisView
import badlog.window.menu.Command
import badlog.window.menu.KeyPress

/** Returns the keys for graphs that exported pages do not have. */
internal fun graphCommands(view: AxisView, scroll: (share: Double) -> Unit, goToEnd: () -> Unit): List<Command> = listOf(
    Command("Graphs", "Scroll the graphs up", listOf(KeyPress(Key.DirectionUp, "↑"))) { scroll(-SCROLLED) },
    Command("Graphs", "Scroll the graphs down", listOf(KeyPress(Key.DirectionDown, "↓"))) { scroll(SCROLLED) },
    Command("Graphs", "Zoom to the selection", listOf(KeyPress(Key.Z, "Z"))) { zoomToSelection(view) },
    Command("Graphs", "Go to the end of the log; follow it if it grows", listOf(KeyPress(Key.MoveEnd, "End")), goToEnd),
)

private const val SCROLLED = 0.25

/** Zooms to the selection. */
internal fun zoomToSelection(view: AxisView) {
    val selection = view.selection ?: return
    view.change { showing(selection.from, selection.to) }
}
