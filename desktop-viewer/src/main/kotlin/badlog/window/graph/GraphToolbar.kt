package badlog.window.graph

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.BoxWithConstraints
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
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.input.KeyAction
import badlog.viewer.state.GraphChange
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

/** The toolbar of the graphs: visible range, playback, and height. In a wide one, each icon has a word beside it. */
@Composable
internal fun GraphToolbar(scene: GraphScene) {
    BoxWithConstraints(Modifier.fillMaxWidth().background(LocalPalette.current.surface)) {
        val hasLabels = maxWidth >= LABELED
        FlowRow(
            Modifier.padding(horizontal = 8.dp, vertical = 2.dp),
            horizontalArrangement = Arrangement.spacedBy(12.dp),
            itemVerticalAlignment = Alignment.CenterVertically,
        ) {
            ViewButtons(scene.current, scene.view, hasLabels)
            LiveButton(scene.live)
            PlaybackButtons(scene.player, isEnabled = scene.current.recording != null, hasLabels)
            HeightButtons(scene.settings, hasLabels)
            BoardButtons(scene.board, hasLabels)
        }
    }
}

@Composable
private fun ViewButtons(current: CurrentRecording, view: AxisView, hasLabels: Boolean) {
    // The view changes with every turn of the wheel, but the buttons hardly ever.
    val isZoomed by remember(view) { derivedStateOf { view.viewport.isZoomed } }
    val hasHistory by remember(view) { derivedStateOf { view.viewport.canGoBack } }
    Row(verticalAlignment = Alignment.CenterVertically) {
        ToolButton("Show everything (0)", text = "All", isEnabled = isZoomed) { view.press(KeyAction.SHOW_ALL) }
        ToolButton("Previous view (Backspace)", Icons.Back, "Previous".takeIf { hasLabels }, isEnabled = hasHistory) {
            view.press(KeyAction.PREVIOUS_VIEW)
        }
        ToolButton("Zoom out (-)", Icons.Remove, "Zoom out".takeIf { hasLabels }, isEnabled = isZoomed) {
            view.press(KeyAction.ZOOM_OUT)
        }
        ToolButton("Zoom in (+)", Icons.Add, "Zoom in".takeIf { hasLabels }) { view.press(KeyAction.ZOOM_IN) }
        if (current.recording?.enabled.orEmpty().isNotEmpty()) {
            ToolButton("Zoom to the time the robot was enabled (E)", text = "Enabled") {
                view.press(KeyAction.SHOW_ENABLED)
            }
        }
    }
}

/** The button to follow a log that is being written; empty for other logs. */
@Composable
private fun LiveButton(live: LiveView) {
    if (!live.isGrowing) return
    val isOn = live.isStaying
    val meaning = if (isOn) "Stay here while the log grows" else "Follow the log while it is written (End)"
    ToolButton(meaning, text = "Live", isOn = isOn) { if (isOn) live.pause() else live.begin() }
}

@Composable
private fun BoardButtons(board: GraphBoard, hasLabels: Boolean) {
    Row(verticalAlignment = Alignment.CenterVertically) {
        ToolButton("Undo (${KeyAction.UNDO.shortcut})", Icons.Undo, "Undo".takeIf { hasLabels }, isEnabled = board.canUndo) { board.undo() }
        ToolButton("Redo (${KeyAction.REDO.shortcut})", Icons.Redo, "Redo".takeIf { hasLabels }, isEnabled = board.canRedo) { board.redo() }
        ToolButton("Remove all graphs", text = "Remove all", isEnabled = board.state.graphs.isNotEmpty()) {
            board.send(GraphChange.ShowOnly(emptyList()))
        }
    }
}

@Composable
private fun HeightButtons(settings: SettingsStore, hasLabels: Boolean) {
    val state = settings.state
    val isShortest = state.graphHeight <= BoardGraph.HEIGHTS.first
    val isTallest = state.graphHeight >= BoardGraph.HEIGHTS.last
    Row(verticalAlignment = Alignment.CenterVertically) {
        ToolButton("Shorter graphs (Ctrl+Shift+wheel)", Icons.Shrink, "Shorter".takeIf { hasLabels }, isEnabled = !isShortest) {
            setGraphHeight(settings, state.graphHeight - HEIGHT_STEP)
        }
        ToolButton("Taller graphs (Ctrl+Shift+wheel)", Icons.Grow, "Taller".takeIf { hasLabels }, isEnabled = !isTallest) {
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

/** From this width, the toolbar has room for all words in a single line. */
private val LABELED = 1020.dp

private const val HEIGHT_STEP = 25
