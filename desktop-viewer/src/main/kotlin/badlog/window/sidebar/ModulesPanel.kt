package badlog.window.sidebar

import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.key
import androidx.compose.runtime.produceState
import androidx.compose.runtime.snapshotFlow
import androidx.compose.ui.Modifier
import badlog.core.analysis.Span
import badlog.viewer.draw.swerve.DrivePicture
import badlog.viewer.panel.Part
import badlog.viewer.panel.modulesPanel
import badlog.viewer.shown.swerve.SwerveDrive
import badlog.viewer.state.Action
import badlog.viewer.text.placeText
import badlog.viewer.text.withUnit
import badlog.window.log.AxisView
import badlog.window.log.OpenRecording
import badlog.window.panel.PanelView
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.flow.conflate
import kotlinx.coroutines.flow.map
import kotlinx.coroutines.withContext

/** The modules of a swerve drive, see [modulesPanel]: at the cursor, and their errors in the visible range. */
@Composable
internal fun ModulesPanel(view: AxisView, open: OpenRecording, send: (Action) -> Unit, modifier: Modifier) {
    val drive = open.drive ?: return PanelHint(SwerveDrive.NONE)
    // Another log must not show the numbers of the previous one; a growing log may show slightly older numbers.
    val parts by key(open.file) {
        produceState<List<Part>?>(null, open) {
            val picture = withContext(Dispatchers.Default) { DrivePicture(drive, drive.errors).also { drive.fastest } }
            snapshotFlow { view.viewport.visible }.conflate().map { visible ->
                withContext(Dispatchers.Default) { partsOf(drive, picture, visible, view, open) }
            }.collect { value = it }
        }
    }
    parts?.let { PanelView(it, goal = null, send, modifier) }
}

private fun partsOf(drive: SwerveDrive, picture: DrivePicture, visible: Span, view: AxisView, open: OpenRecording): List<Part> {
    val axis = open.view.xAxis
    fun placeOf(x: Double) = withUnit(placeText(x, axis, visible.width), axis.unit)
    return modulesPanel(drive, drive.errors?.within(visible).orEmpty(), ::placeOf, picture) { pen, width, colors ->
        // Reads the place while drawing, so that moving a cursor only redraws the picture.
        draw(pen, width, view.viewport.visible, view.cursors, colors)
    }
}
