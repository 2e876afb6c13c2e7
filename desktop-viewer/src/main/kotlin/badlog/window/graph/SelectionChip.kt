package badlog.window.graph

import androidx.compose.foundation.background
import androidx.compose.foundation.border
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.shape.RoundedCornerShape
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.layout.layout
import androidx.compose.ui.unit.Dp
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.viewer.state.PlaceAction
import badlog.viewer.text.lengthText
import badlog.window.graph.plot.pixelOf
import badlog.window.graph.scene.GraphScene
import badlog.window.theme.Icons
import badlog.window.theme.LocalPalette
import badlog.window.theme.ToolButton

/** The length of the selection, and actions for it; floats below it, in a pane [width] wide. */
@Composable
internal fun SelectionChip(scene: GraphScene, width: Dp) {
    val selection = scene.view.selection ?: return
    val axis = scene.current.recording?.view?.xAxis ?: return
    val palette = LocalPalette.current
    val right = scene.rightGutter
    Row(
        Modifier
            .layout { measurable, constraints ->
                val chip = measurable.measure(constraints.copy(minWidth = 0, minHeight = 0))
                val height = constraints.maxHeight
                layout(constraints.maxWidth, height) {
                    val plot = (width - GraphScene.LEFT_GUTTER - right).toPx()
                    val center = pixelOf((selection.from + selection.to) / 2, scene.view.viewport.visible, plot)
                    val left = GraphScene.LEFT_GUTTER.toPx() + center - chip.width / 2
                    val most = maxOf(0f, constraints.maxWidth - chip.width - right.toPx())
                    chip.place(left.coerceIn(0f, most).toInt(), height - chip.height - BOTTOM.dp.roundToPx())
                }
            }
            .border(1.dp, palette.accent, RoundedCornerShape(6.dp))
            .background(palette.raised, RoundedCornerShape(6.dp)),
        verticalAlignment = Alignment.CenterVertically,
    ) {
        Text("Δ ${lengthText(selection.width, axis)}", Modifier.padding(horizontal = 8.dp), fontSize = 12.sp, maxLines = 1)
        ToolButton("Zoom to the selection (Z)", text = "Zoom") { scene.view.send(PlaceAction.ShowSelection) }
        ToolButton("Clear the selection (Escape)", Icons.Close) { scene.view.send(PlaceAction.Select(null)) }
    }
}

private const val BOTTOM = 8
