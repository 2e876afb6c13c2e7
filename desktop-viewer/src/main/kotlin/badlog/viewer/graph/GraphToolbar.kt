package badlog.viewer.graph

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
import badlog.viewer.app.Viewer
import badlog.viewer.playback.PlaybackButtons
import badlog.viewer.theme.Icons
import badlog.viewer.theme.LocalPalette
import badlog.viewer.theme.ToolButton

/** What can be done with the view: where to look, playback, and how high graphs are. */
@Composable
internal fun GraphToolbar(scene: GraphScene) {
    val viewer = scene.viewer
    FlowRow(
        Modifier.fillMaxWidth().background(LocalPalette.current.surface).padding(horizontal = 8.dp, vertical = 2.dp),
        horizontalArrangement = Arrangement.spacedBy(12.dp),
        itemVerticalAlignment = Alignment.CenterVertically,
    ) {
        ViewButtons(viewer)
        PlaybackButtons(viewer)
        HeightButtons(viewer)
    }
}

@Composable
private fun ViewButtons(viewer: Viewer) {
    // The view changes at the speed of the wheel, what the buttons show of it hardly ever.
    val isZoomed by remember(viewer) { derivedStateOf { viewer.viewport.isZoomed } }
    val hasHistory by remember(viewer) { derivedStateOf { viewer.viewport.canGoBack } }
    Row(verticalAlignment = Alignment.CenterVertically) {
        ToolButton("Show everything (0)", text = "All", isEnabled = isZoomed) { viewer.viewport = viewer.viewport.reset() }
        ToolButton("Previous view (Backspace)", Icons.Back, isEnabled = hasHistory) {
            viewer.viewport = viewer.viewport.back()
        }
        ToolButton("Zoom out (-)", Icons.Remove, isEnabled = isZoomed) { viewer.viewport = viewer.viewport.zoomed(-1, viewer.cursor) }
        ToolButton("Zoom in (+)", Icons.Add) { viewer.viewport = viewer.viewport.zoomed(1, viewer.cursor) }
        if (viewer.open?.enabled.orEmpty().isNotEmpty()) {
            ToolButton("Zoom to the time the robot was enabled (E)", text = "Enabled") {
                viewer.viewport = viewer.viewport.showingEnabled(viewer.open?.enabled.orEmpty())
            }
        }
    }
}

@Composable
private fun HeightButtons(viewer: Viewer) {
    val settings = viewer.settings
    Row(verticalAlignment = Alignment.CenterVertically) {
        ToolButton("Shorter graphs (Ctrl+Shift+wheel)", Icons.Shrink, isEnabled = settings.graphHeight > HEIGHTS.first) {
            setGraphHeight(viewer, settings.graphHeight - HEIGHT_STEP)
        }
        ToolButton("Taller graphs (Ctrl+Shift+wheel)", Icons.Grow, isEnabled = settings.graphHeight < HEIGHTS.last) {
            setGraphHeight(viewer, settings.graphHeight + HEIGHT_STEP)
        }
        ToolButton("Share the window's height among few graphs", text = "Fit", isOn = settings.fitsGraphs) {
            viewer.settings = settings.copy(fitsGraphs = !settings.fitsGraphs)
        }
    }
}

/** Makes graphs [height] dp high, or as near as they may be; they no longer share the window's height. */
internal fun setGraphHeight(viewer: Viewer, height: Int) {
    viewer.settings = viewer.settings.copy(graphHeight = height.coerceIn(HEIGHTS), fitsGraphs = false)
}

private const val HEIGHT_STEP = 25
