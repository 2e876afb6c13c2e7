package badlog.window.graph

import androidx.compose.foundation.layout.Spacer
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clipToBounds
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.graphicsLayer
import badlog.core.analysis.Span
import badlog.viewer.draw.plot.PlotFrame
import badlog.viewer.draw.plot.drawCursors
import badlog.viewer.draw.plot.drawSamples
import badlog.viewer.input.DragKind
import badlog.window.graph.mark.drawBand
import badlog.window.graph.mark.drawShownFinding
import badlog.window.graph.plot.PlotPicture
import badlog.window.graph.plot.PlotState
import badlog.window.graph.plot.pixelOf
import badlog.window.graph.scene.GraphScene
import badlog.window.log.PlotGesture
import badlog.window.pen.pen
import badlog.window.theme.LocalPalette
import badlog.window.theme.Palette

/** Everything that moves with the pointer: the cursor with the samples it reads, the selection, a finding, and what is being dragged. */
@Composable
internal fun CursorOverlay(scene: GraphScene, id: Int, state: PlotState) {
    val palette = LocalPalette.current
    Spacer(
        Modifier.fillMaxSize().clipToBounds().graphicsLayer().drawBehind {
            val visible = scene.view.viewport.visible
            scene.findings.shown?.let { drawShownFinding(it, visible, palette) }
            scene.view.selection?.let { drawSelection(it, visible, palette) }
            scene.view.gesture?.let { drawGesture(it, id, visible, scene.pictureOf(state), palette) }
            val frame = PlotFrame(0.0, 0.0, size.width.toDouble(), size.height.toDouble(), visible)
            val pen = pen()
            pen.drawCursors(frame, scene.view.cursors, palette.pen)
            val cursor = scene.view.cursor ?: return@drawBehind
            scene.pictureOf(state)?.let { pen.drawSamples(frame, it.plot, it.lines, cursor, palette.pen) }
        },
    )
}

/** Draws [selection] as a band with its edges. */
internal fun DrawScope.drawSelection(selection: Span, visible: Span, palette: Palette) {
    drawBand(selection, visible, palette.accent.copy(alpha = BAND_OPACITY))
    for (edge in listOf(selection.from, selection.to)) {
        if (edge !in visible) continue
        val x = pixelOf(edge, visible, size.width)
        drawLine(palette.accent, Offset(x, 0f), Offset(x, size.height), strokeWidth = density)
    }
}

private fun DrawScope.drawGesture(gesture: PlotGesture, id: Int, visible: Span, picture: PlotPicture?, palette: Palette) {
    val drag = gesture.drag
    when (drag.kind) {
        DragKind.PAN -> Unit

        DragKind.ZOOM, DragKind.SELECT -> drawSelection(drag.xSpan, visible, palette)

        DragKind.ZOOM_Y -> {
            if (gesture.graph != id || picture == null) return
            val top = drag.ySpan.from.toFloat() * picture.plotHeight
            val bottom = drag.ySpan.to.toFloat() * picture.plotHeight
            drawRect(palette.accent.copy(alpha = BAND_OPACITY), Offset(0f, top), Size(size.width, bottom - top))
            for (y in listOf(top, bottom)) drawLine(palette.accent, Offset(0f, y), Offset(size.width, y), strokeWidth = density)
        }
    }
}

private const val BAND_OPACITY = 0.16f
