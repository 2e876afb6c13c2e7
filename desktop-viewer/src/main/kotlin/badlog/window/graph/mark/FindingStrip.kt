package badlog.window.graph.mark

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.input.pointer.PointerEventType
import androidx.compose.ui.input.pointer.pointerInput
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.unit.dp
import badlog.viewer.draw.plot.drawFindingMarks
import badlog.window.graph.plot.frameOf
import badlog.window.graph.scene.GraphScene
import badlog.window.pen.pen
import badlog.window.theme.LocalPalette

/**
 * The marks of the findings on the time axis. The pointer on one shades its time and shows its text; a click goes there. The strip takes up
 * its space even without findings, because graphs that shrink later would be drawn twice.
 */
@Composable
internal fun FindingStrip(scene: GraphScene) {
    val palette = LocalPalette.current
    Box(Modifier.fillMaxWidth().height(HEIGHT.dp).background(palette.surface)) {
        Box(
            Modifier
                .fillMaxSize()
                .padding(start = GraphScene.LEFT_GUTTER, end = scene.rightGutter)
                .semantics { contentDescription = "Findings on the time axis" }
                .findingPointer(scene)
                .drawBehind {
                    val frame = frameOf(scene.view.viewport.visible)
                    scene.findings.state.list?.let { pen().drawFindingMarks(frame, it.timeline, palette.pen) }
                },
        )
    }
}

private fun Modifier.findingPointer(scene: GraphScene): Modifier = pointerInput(scene) {
    awaitPointerEventScope {
        while (true) {
            val event = awaitPointerEvent()
            val visible = scene.view.viewport.visible
            val change = event.changes.first()
            val x = visible.from + change.position.x / size.width * visible.width
            val reach = REACH * density / size.width * visible.width
            val found = scene.findings.state.list?.timeline?.pointedAt(x, reach, visible)
            val place = if (found == null) Double.NaN else found.placeNear(x)?.from ?: found.time
            when (event.type) {
                PointerEventType.Enter, PointerEventType.Move -> scene.findings.point(found, place)
                PointerEventType.Exit -> scene.findings.point(null)
                PointerEventType.Release -> if (found != null) scene.findings.goTo(found, place)
                else -> Unit
            }
        }
    }
}

private const val HEIGHT = 14
private const val REACH = 6
