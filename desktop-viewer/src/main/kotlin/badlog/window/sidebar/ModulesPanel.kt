package badlog.window.sidebar

import androidx.compose.foundation.background
import androidx.compose.foundation.clickable
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.Spacer
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.size
import androidx.compose.foundation.layout.width
import androidx.compose.foundation.rememberScrollState
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.foundation.verticalScroll
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.getValue
import androidx.compose.runtime.key
import androidx.compose.runtime.produceState
import androidx.compose.runtime.snapshotFlow
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clipToBounds
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.semantics.Role
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.font.FontWeight
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.viewer.draw.swerve.DrivePicture
import badlog.viewer.shown.swerve.DriveErrors
import badlog.viewer.shown.swerve.ErrorSize
import badlog.viewer.shown.swerve.ModuleError
import badlog.viewer.shown.swerve.SwerveDrive
import badlog.viewer.shown.swerve.worstModuleText
import badlog.viewer.state.PlaceAction
import badlog.viewer.text.placeText
import badlog.viewer.text.withUnit
import badlog.window.log.AxisView
import badlog.window.log.OpenRecording
import badlog.window.pen.pen
import badlog.window.theme.LocalPalette
import badlog.window.theme.NameText
import badlog.window.theme.Tip
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.flow.conflate
import kotlinx.coroutines.flow.map
import kotlinx.coroutines.withContext

/**
 * The modules of a swerve drive: their values at the cursor, and their errors in the visible range.
 *
 * @param showGraphs is called when a person goes to a moment.
 */
@Composable
internal fun ModulesPanel(view: AxisView, open: OpenRecording, showGraphs: () -> Unit, modifier: Modifier) {
    val drive = open.drive ?: return PanelHint(SwerveDrive.NONE)
    // Another log must not show the numbers of the previous one; a growing log may show slightly older numbers.
    val made by key(open.file) {
        produceState<ShownModules?>(null, open) {
            val picture = withContext(Dispatchers.Default) { DrivePicture(drive, drive.errors).also { drive.fastest } }
            snapshotFlow { view.viewport.visible }.conflate().map { visible ->
                withContext(Dispatchers.Default) { ShownModules(picture, drive.errors, drive.errors?.within(visible).orEmpty()) }
            }.collect { value = it }
        }
    }
    val shown = made ?: return
    val palette = LocalPalette.current
    Column(modifier.verticalScroll(rememberScrollState()).padding(vertical = 8.dp)) {
        Text(
            shown.errors?.let { worstModuleText(shown.sizes) } ?: drive.errorsLack.orEmpty(),
            Modifier.padding(horizontal = 12.dp),
            fontWeight = FontWeight.Medium,
        )
        Spacer(
            Modifier.fillMaxWidth().height(shown.picture.height.dp).clipToBounds()
                .semantics { contentDescription = "Modules at the cursor" }
                .drawBehind { shown.picture.draw(pen(), size.width.toDouble(), view.viewport.visible, view.cursors, palette.pen) },
        )
        Note(SwerveDrive.ARROWS)
        shown.sizes.forEachIndexed { i, error ->
            ErrorLine(error, i, { withUnit(placeText(it, open.view.xAxis, view.viewport.visible.width), open.view.xAxis.unit) }) { x ->
                view.send(PlaceAction.GoTo(x))
                showGraphs()
            }
        }
        shown.errors?.let { Note(it.condition) }
    }
}

/** The content of the panel for a log: its [errors], null if unknown, and their [sizes] over the visible range. */
private class ShownModules(val picture: DrivePicture, val errors: DriveErrors?, val sizes: List<ModuleError>)

@Composable
private fun Note(text: String) =
    Text(text, Modifier.padding(horizontal = 12.dp, vertical = 2.dp), color = LocalPalette.current.muted, fontSize = 12.sp)

/** The errors of module [index]; [placeOf] returns a place on x as text. */
@Composable
private fun ErrorLine(error: ModuleError, index: Int, placeOf: (Double) -> String, onGo: (Double) -> Unit) {
    Row(Modifier.fillMaxWidth().padding(horizontal = 12.dp, vertical = 3.dp), Arrangement.spacedBy(8.dp)) {
        Box(Modifier.padding(top = 4.dp).size(10.dp).background(LocalPalette.current.line(index), RoundedCornerShape(2.dp)))
        NameText(error.label, Modifier.width(NAME.dp), fontWeight = FontWeight.Medium)
        Column(Modifier.weight(1f)) {
            for (size in listOfNotNull(error.angle, error.speed)) {
                SizeLine(size, size.goText(placeOf(size.largestAt)), onGo)
            }
        }
    }
}

/** The [size] of an error; its largest value is a button with the effect described by [hint]. */
@Composable
private fun SizeLine(size: ErrorSize, hint: String, onGo: (Double) -> Unit) {
    Row(verticalAlignment = Alignment.CenterVertically) {
        Text(size.rmsText, Modifier.weight(1f), maxLines = 1)
        Tip(hint) {
            Text(
                size.largestText,
                Modifier.clickable(role = Role.Button) { onGo(size.largestAt) }
                    .semantics { contentDescription = "${size.largestText}: $hint" },
                color = LocalPalette.current.accent,
                maxLines = 1,
            )
        }
    }
}

private const val NAME = 80
