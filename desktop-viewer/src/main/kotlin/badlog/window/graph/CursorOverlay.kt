package badlog.window.graph

import androidx.compose.foundation.layout.Spacer
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.clipToBounds
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.PathEffect
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.graphicsLayer
import badlog.core.analysis.Span
import badlog.viewer.input.DragKind
import badlog.viewer.shown.cursor.Cursors
import badlog.viewer.shown.cursor.dotAt
import badlog.viewer.shown.cursor.indexAt
import badlog.window.graph.mark.drawBand
import badlog.window.graph.mark.drawShownFinding
import badlog.window.graph.plot.PlotPicture
import badlog.window.graph.plot.PlotState
import badlog.window.graph.plot.pixelOf
import badlog.window.graph.scene.GraphScene
import badlog.window.log.PlotGesture
import badlog.window.theme.LocalPalette
import badlog.window.theme.Palette

/** Everything that moves with the pointer: the cursor with the samples it reads, the selection, a finding, and what is being dragged. */
@Composable
internal fun CursorOverlay(scene: GraphScene, id: Int, state: PlotState) {
    val palette = LocalPalette.current
    Spacer(
        Modifier.fillMaxSize().clipToBounds().graphicsLayer().drawBehind {
            val visible = scene.view.viewport.visible
            scene.findings.state.shown?.let { drawShownFinding(it, visible, palette) }
            scene.view.selection?.let { drawSelection(it, visible, palette) }
            scene.view.gesture?.let { drawGesture(it, id, visible, scene.pictureOf(state), palette) }
            drawCursors(scene.view.cursors, visible, palette)
            val cursor = scene.view.cursor ?: return@drawBehind
            if (cursor in visible) scene.pictureOf(state)?.let { drawSamples(it, cursor, visible, palette) }
        },
    )
}

/** Draws [cursors] over the whole height: pinned ones in the accent color, the second one dashed, the pointer's thin. */
internal fun DrawScope.drawCursors(cursors: Cursors, visible: Span, palette: Palette) {
    val pointer = palette.cursor.copy(alpha = if (cursors.isPinned) POINTER_OPACITY else CURSOR_OPACITY)
    cursors.hover?.let { drawCursorLine(it, visible, pointer, density) }
    cursors.pinned?.let { drawCursorLine(it, visible, palette.accent, PINNED * density) }
    val dashes = PathEffect.dashPathEffect(floatArrayOf(DASH * density, DASH * density))
    cursors.second?.let { drawCursorLine(it, visible, palette.accent, PINNED * density, dashes) }
}

private fun DrawScope.drawCursorLine(cursor: Double, visible: Span, color: Color, width: Float, effect: PathEffect? = null) {
    if (cursor !in visible) return
    val x = pixelOf(cursor, visible, size.width)
    drawLine(color, Offset(x, 0f), Offset(x, size.height), strokeWidth = width, pathEffect = effect)
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
    when (gesture.kind) {
        DragKind.PAN -> Unit

        DragKind.ZOOM, DragKind.SELECT -> drawSelection(gesture.xSpan, visible, palette)

        DragKind.ZOOM_Y -> {
            val axis = picture?.axes?.firstOrNull() ?: return
            if (gesture.graph != id) return
            val top = axis.pixelOf(gesture.ySpan.to, picture.plotHeight)
            val bottom = axis.pixelOf(gesture.ySpan.from, picture.plotHeight)
            drawRect(palette.accent.copy(alpha = BAND_OPACITY), Offset(0f, top), Size(size.width, bottom - top))
            for (y in listOf(top, bottom)) drawLine(palette.accent, Offset(0f, y), Offset(size.width, y), strokeWidth = density)
        }
    }
}

/** Draws a dot on each line where the legend reads it: at the sample, or where its value holds. */
private fun DrawScope.drawSamples(picture: PlotPicture, cursor: Double, visible: Span, palette: Palette) {
    for (line in picture.lines) {
        val read = line.line.signal.line
        val index = read.indexAt(cursor - line.line.offset)
        if (index < 0) continue
        val value = read.data.y[index]
        val x = pixelOf(read.dotAt(cursor - line.line.offset) + line.line.offset, visible, size.width)
        if (!value.isFinite() || x < 0 || x > size.width) continue
        val y = picture.axes[line.axis].pixelOf(value, picture.plotHeight)
        if (y < 0 || y > picture.plotHeight) continue
        drawCircle(palette.surface, (DOT + 1) * density, Offset(x, y))
        drawCircle(palette.line(line.line.color), DOT * density, Offset(x, y))
    }
}

private const val CURSOR_OPACITY = 0.75f
private const val POINTER_OPACITY = 0.4f
private const val PINNED = 2f
private const val DASH = 4f
private const val BAND_OPACITY = 0.16f
private const val DOT = 3f
