package badlog.viewer.graph

import androidx.compose.ui.input.key.Key
import badlog.viewer.app.Viewer
import badlog.viewer.keyboard.Command
import badlog.viewer.keyboard.KeyPress

/** What the keyboard does with the graphs. */
internal fun graphCommands(viewer: Viewer): List<Command> {
    fun command(meaning: String, vararg keys: KeyPress, action: () -> Unit) = Command(GROUP, meaning, keys.toList(), action)
    val pan = { share: Double -> viewer.viewport = viewer.viewport.panned(share) }
    return listOf(
        command("Cursor to the sample before", KeyPress(Key.DirectionLeft, "←")) { stepCursor(viewer, -1) },
        command("Cursor to the next sample", KeyPress(Key.DirectionRight, "→")) { stepCursor(viewer, 1) },
        command("Cursor ten samples back", KeyPress(Key.DirectionLeft, "←", shift = true)) { stepCursor(viewer, -STRIDE) },
        command("Cursor ten samples on", KeyPress(Key.DirectionRight, "→", shift = true)) { stepCursor(viewer, STRIDE) },
        command(
            "Zoom in",
            KeyPress(Key.Plus, "+"),
            KeyPress(Key.Plus, "+", shift = true),
            KeyPress(Key.Equals, "="),
            KeyPress(Key.Equals, "=", shift = true),
            KeyPress(Key.NumPadAdd, "+"),
        ) { viewer.viewport = viewer.viewport.zoomed(1, viewer.cursor) },
        command("Zoom out", KeyPress(Key.Minus, "-"), KeyPress(Key.NumPadSubtract, "-")) {
            viewer.viewport = viewer.viewport.zoomed(-1, viewer.cursor)
        },
        command("Show everything", KeyPress(Key.Zero, "0"), KeyPress(Key.MoveHome, "Home")) { viewer.viewport = viewer.viewport.reset() },
        command("Previous view", KeyPress(Key.Backspace, "Backspace")) { viewer.viewport = viewer.viewport.back() },
        command("Next view", KeyPress(Key.Backspace, "Backspace", shift = true)) { viewer.viewport = viewer.viewport.forward() },
        command("Zoom to the time enabled", KeyPress(Key.E, "E")) { zoomToEnabled(viewer) },
        command("Zoom to the selection", KeyPress(Key.Z, "Z")) { zoomToSelection(viewer) },
        command("Move to the left", KeyPress(Key.LeftBracket, "[")) { pan(-PAN) },
        command("Move to the right", KeyPress(Key.RightBracket, "]")) { pan(PAN) },
    )
}

private const val GROUP = "Graphs"
private const val STRIDE = 10
private const val PAN = 0.25
