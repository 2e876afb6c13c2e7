package badlog.window.graph.scene

import androidx.compose.ui.input.key.Key
import badlog.window.log.AxisView
import badlog.window.log.CurrentRecording
import badlog.window.menu.Command
import badlog.window.menu.KeyPress

/** Returns the keys for graphs that exported pages do not have. */
internal fun graphCommands(view: AxisView, scroll: (share: Double) -> Unit): List<Command> = listOf(
    Command("Graphs", "Scroll the graphs up", listOf(KeyPress(Key.DirectionUp, "↑"))) { scroll(-SCROLLED) },
    Command("Graphs", "Scroll the graphs down", listOf(KeyPress(Key.DirectionDown, "↓"))) { scroll(SCROLLED) },
    Command("Graphs", "Zoom to the selection", listOf(KeyPress(Key.Z, "Z"))) { zoomToSelection(view) },
)

private const val SCROLLED = 0.25

/** Zooms to the selection. */
internal fun zoomToSelection(view: AxisView) {
    val selection = view.selection ?: return
    view.change { showing(selection.from, selection.to) }
}

/** Moves a cursor by [samples] of the open recording, or to the sample in the middle of the view, and makes it visible. */
internal fun stepCursor(current: CurrentRecording, view: AxisView, samples: Int) {
    val steps = current.recording?.cursorSteps ?: return
    val visible = view.viewport.visible
    val start = steps.nearest(visible.from + visible.width / 2)
    if (start.isNaN()) return
    view.changeCursors { moved(start) { steps.from(it, samples) } }
    view.cursors.moving?.let { x -> view.change { revealing(x) } }
}
