package badlog.window.graph.scene

import androidx.compose.ui.input.key.Key
import badlog.viewer.state.PlaceAction
import badlog.window.log.AxisView
import badlog.window.menu.Command
import badlog.window.menu.KeyPress

/** Returns the graph commands that exported pages do not have. */
internal fun graphCommands(view: AxisView, scroll: (share: Double) -> Unit, goToEnd: () -> Unit): List<Command> = listOf(
    Command("Graphs", "Scroll the graphs up", listOf(KeyPress(Key.DirectionUp, "↑"))) { scroll(-SCROLLED) },
    Command("Graphs", "Scroll the graphs down", listOf(KeyPress(Key.DirectionDown, "↓"))) { scroll(SCROLLED) },
    Command("Graphs", "Zoom to the selection", listOf(KeyPress(Key.Z, "Z"))) { view.send(PlaceAction.ShowSelection) },
    Command("Graphs", "Go to the end of the log; follow it if it grows", listOf(KeyPress(Key.MoveEnd, "End")), goToEnd),
)

private const val SCROLLED = 0.25
