package badlog.window.graph

import androidx.compose.foundation.layout.Spacer
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clipToBounds
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.graphics.graphicsLayer
import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.pen.Pen
import badlog.viewer.draw.plot.PlotFrame
import badlog.viewer.draw.plot.drawCursors
import badlog.viewer.draw.plot.drawFinding
import badlog.viewer.draw.plot.drawSamples
import badlog.viewer.draw.plot.drawSelectedHeights
import badlog.viewer.draw.plot.drawSelection
import badlog.viewer.input.DragKind
import badlog.window.graph.plot.PlotPicture
import badlog.window.graph.plot.PlotState
import badlog.window.graph.plot.frameOf
import badlog.window.graph.scene.GraphScene
import badlog.window.log.PlotGesture
import badlog.window.pen.pen
import badlog.window.theme.LocalPalette

/** Everything that moves with the pointer: the cursor with the samples it reads, the selection, a finding, and a drag. */
@Composable
internal fun CursorOverlay(scene: GraphScene, id: Int, state: PlotState) {
    val palette = LocalPalette.current
    Spacer(
        Modifier.fillMaxSize().clipToBounds().graphicsLayer().drawBehind {
            val frame = frameOf(scene.view.viewport.visible)
            val pen = pen()
            scene.findings.shown?.let { pen.drawFinding(frame, it, palette.pen) }
            scene.view.selection?.let { pen.drawSelection(frame, it, palette.pen) }
            scene.view.gesture?.let { pen.drawGesture(it, id, frame, scene.pictureOf(state), palette.pen) }
            pen.drawCursors(frame, scene.view.cursors, palette.pen)
            val cursor = scene.view.cursor ?: return@drawBehind
            scene.pictureOf(state)?.let { pen.drawSamples(frame, it.plot, it.lines, cursor, palette.pen) }
        },
    )
}

private fun Pen.drawGesture(gesture: PlotGesture, id: Int, frame: PlotFrame, picture: PlotPicture?, colors: PenColors) {
    val drag = gesture.drag
    when (drag.kind) {
        DragKind.PAN -> Unit

        DragKind.ZOOM, DragKind.SELECT -> drawSelection(frame, drag.xSpan, colors)

        DragKind.ZOOM_Y -> {
            if (gesture.graph != id || picture == null) return
            drawSelectedHeights(frame, drag.ySpan.from * picture.plotHeight, drag.ySpan.to * picture.plotHeight, colors)
        }
    }
}
