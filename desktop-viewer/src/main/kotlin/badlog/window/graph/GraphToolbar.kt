package badlog.window.graph

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import androidx.compose.runtime.remember
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.input.Action
import badlog.window.graph.scene.GraphScene
import badlog.window.log.AxisView
import badlog.window.log.CurrentRecording
import badlog.window.log.GraphBoard
import badlog.window.log.LiveView
import badlog.window.settings.SettingsStore
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.ToolButton
import badlog.window.video.PlaybackButtons

/** The toolbar of the graphs: visible range, playback, and height. */
@Composable
internal fun GraphToolbar(scene: GraphScene) {
    FlowRow(
        Modifier.fillMaxWidth().background(LocalPalette.current.surface).padding(horizontal = 8.dp, vertical = 2.dp),
        horizontalArrangement = Arrangement.spacedBy(12.dp),
        itemVerticalAlignment = Alignment.CenterVertically,
    ) {
        ViewButtons(scene.current, scene.view)
        LiveButton(scene.live)
        PlaybackButtons(scene.player, isEnabled = scene.current.recording != null)
        HeightButtons(scene.settings)
        BoardButtons(scene.board)
    }
}

@Composable
private fun ViewButtons(current: CurrentRecording, view: AxisView) {
    // The view changes with every turn of the wheel, but the buttons hardly ever.
    val isZoomed by remember(view) { derivedStateOf { view.viewport.isZoomed } }
    val hasHistory by remember(view) { derivedStateOf { view.viewport.canGoBack } }
    Row(verticalAlignment = Alignment.CenterVertically) {
        ToolButton("Show everything (0)", text = "All", isEnabled = isZoomed) { view.change { reset() } }
        ToolButton("Previous view (Backspace)", Icons.Back, isEnabled = hasHistory) {
            view.change { back() }
        }
        ToolButton("Zoom out (-)", Icons.Remove, isEnabled = isZoomed) { view.change { zoomed(-1, view.cursor) } }
        ToolButton("Zoom in (+)", Icons.Add) { view.change { zoomed(1, view.cursor) } }
        if (current.recording?.enabled.orEmpty().isNotEmpty()) {
            ToolButton("Zoom to the time the robot was enabled (E)", text = "Enabled") {
                view.change { showingEnabled(current.recording?.enabled.orEmpty()) }
            }
        }
    }
}

/** Only for a log that is being written. */
@Composable
private fun LiveButton(live: LiveView) {
    if (!live.isGrowing) return
    val isOn = live.isStaying
    val meaning = if (isOn) "Stay here while the log grows" else "Follow the log while it is written (End)"
    ToolButton(meaning, text = "Live", isOn = isOn) { if (isOn) live.pause() else live.begin() }
}

@Composable
private fun BoardButtons(board: GraphBoard) {
    Row(verticalAlignment = Alignment.CenterVertically) {
        ToolButton("Undo (${Action.UNDO.shortcut})", Icons.Undo, isEnabled = board.canUndo) { board.undo() }
        ToolButton("Redo (${Action.REDO.shortcut})", Icons.Redo, isEnabled = board.canRedo) { board.redo() }
        ToolButton("Remove all graphs", text = "Remove all", isEnabled = board.state.graphs.isNotEmpty()) { board.change { Board() } }
    }
}

@Composable
private fun HeightButtons(settings: SettingsStore) {
    val state = settings.state
    Row(verticalAlignment = Alignment.CenterVertically) {
        ToolButton("Shorter graphs (Ctrl+Shift+wheel)", Icons.Shrink, isEnabled = state.graphHeight > BoardGraph.HEIGHTS.first) {
            setGraphHeight(settings, state.graphHeight - HEIGHT_STEP)
        }
        ToolButton("Taller graphs (Ctrl+Shift+wheel)", Icons.Grow, isEnabled = state.graphHeight < BoardGraph.HEIGHTS.last) {
            setGraphHeight(settings, state.graphHeight + HEIGHT_STEP)
        }
        ToolButton("Share the window's height among few graphs", text = "Fit", isOn = state.fitsGraphs) {
            settings.change { copy(fitsGraphs = !fitsGraphs) }
        }
    }
}

/** Makes graphs [height] dp high, within their limits; they no longer share the window's height. */
internal fun setGraphHeight(settings: SettingsStore, height: Int) {
    settings.change { copy(graphHeight = height.coerceIn(BoardGraph.HEIGHTS), fitsGraphs = false) }
}

private const val HEIGHT_STEP = 25
