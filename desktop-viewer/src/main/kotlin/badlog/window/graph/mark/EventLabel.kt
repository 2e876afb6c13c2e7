package badlog.window.graph.mark

import androidx.compose.foundation.layout.BoxWithConstraints
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import androidx.compose.ui.layout.layout
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.viewer.draw.mark.markNear
import badlog.window.graph.plot.pixelOf
import badlog.window.graph.scene.GraphScene
import badlog.window.theme.LocalPalette
import badlog.window.theme.labelFrame

/** The text of the note or event near the pointer, or otherwise near the cursor. It is above the graphs, which stay visible. */
@Composable
internal fun EventLabel(scene: GraphScene) {
    val event by remember(scene) { derivedStateOf { scene.view.cursors.pointed?.let { saidAt(it, scene) } } }
    val shown = event ?: return
    val palette = LocalPalette.current
    BoxWithConstraints(Modifier.fillMaxWidth().padding(start = GraphScene.LEFT_GUTTER, end = scene.rightGutter)) {
        Text(
            shown.text.take(MAX_LETTERS),
            Modifier
                .layout { measurable, constraints ->
                    val label = measurable.measure(constraints.copy(minWidth = 0, maxWidth = constraints.maxWidth / 2))
                    layout(constraints.maxWidth, label.height) {
                        val x = pixelOf(shown.x, scene.view.viewport.visible, constraints.maxWidth.toFloat())
                        val beside = SIDE.dp.roundToPx()
                        // The label is on the other side if this one has too little room.
                        val left = if (x + beside + label.width <= constraints.maxWidth) x + beside else x - beside - label.width
                        label.place(left.toInt().coerceAtLeast(0), -label.height)
                    }
                }
                .labelFrame(palette.event),
            fontSize = 12.sp,
            maxLines = 2,
            overflow = TextOverflow.Ellipsis,
        )
    }
}

private fun saidAt(cursor: Double, scene: GraphScene) =
    markNear(cursor, scene.view.viewport.visible, scene.notes.all, scene.events.matching)

private const val SIDE = 8
private const val MAX_LETTERS = 400
