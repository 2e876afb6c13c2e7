package badlog.viewer.graph

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.height
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import androidx.compose.ui.draw.drawBehind
import androidx.compose.ui.geometry.CornerRadius
import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.input.pointer.PointerIcon
import androidx.compose.ui.input.pointer.pointerHoverIcon
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.TextMeasurer
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.drawText
import androidx.compose.ui.text.rememberTextMeasurer
import androidx.compose.ui.text.style.TextOverflow
import androidx.compose.ui.unit.Constraints
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.analysis.Span
import badlog.plot.axis.Ticks
import badlog.plot.text.cursorText
import badlog.viewer.graph.plot.pixelOf
import badlog.viewer.graph.scene.GraphScene
import badlog.viewer.graph.scene.plotPointer
import badlog.viewer.theme.LocalPalette
import badlog.viewer.theme.Palette

/** The common x axis below the graphs, with where the cursor stands; dragging it pans. */
@Composable
internal fun XAxisBar(scene: GraphScene) {
    val palette = LocalPalette.current
    val letters = rememberTextMeasurer(cacheSize = TEXTS)
    val style = remember(palette) { TextStyle(color = palette.muted, fontSize = 11.sp) }
    val strong = remember(palette) { TextStyle(color = palette.surface, fontSize = 11.sp) }
    Box(Modifier.fillMaxWidth().height(HEIGHT.dp).background(palette.surface)) {
        Box(
            Modifier
                .fillMaxSize()
                .padding(start = GraphScene.LEFT_GUTTER, end = scene.rightGutter)
                .pointerHoverIcon(PointerIcon.Hand)
                .semantics { contentDescription = "Axis" }
                .plotPointer(scene, id = null) { _, _ -> Double.NaN }
                .drawBehind {
                    val axis = scene.current.recording?.view?.xAxis ?: return@drawBehind
                    val visible = scene.view.viewport.visible
                    drawPlaces(visible, axis.title, letters, style, palette)
                    val cursor = scene.view.cursor ?: return@drawBehind
                    if (cursor !in visible) return@drawBehind
                    val text = cursorText(cursor, axis, visible.width, scene.current.recording?.enabled.orEmpty())
                    drawFlag(pixelOf(cursor, visible, size.width), text, scene.view.isCursorPinned, letters, strong, palette)
                },
        )
    }
}

private fun DrawScope.drawPlaces(visible: Span, title: String, letters: TextMeasurer, style: TextStyle, palette: Palette) {
    drawLine(palette.border, Offset.Zero, Offset(size.width, 0f))
    val name = letters.measure(
        title.take(MAX_LETTERS),
        style,
        TextOverflow.Ellipsis,
        softWrap = false,
        maxLines = 1,
        constraints = Constraints(maxWidth = (size.width / 4).toInt().coerceAtLeast(1)),
    )
    val top = TICK * density
    drawText(name, topLeft = Offset(size.width - name.size.width, top))
    val ticks = Ticks.ofX(visible, size.width.toDp().value.toDouble())
    ticks.texts.forEachIndexed { index, number ->
        val x = pixelOf(ticks.values[index], visible, size.width)
        drawLine(palette.muted, Offset(x, 0f), Offset(x, TICK * density))
        val text = letters.measure(number, style)
        val left = x - text.size.width / 2
        if (left + text.size.width < size.width - name.size.width - GAP * density) drawText(text, topLeft = Offset(left, top))
    }
}

/** Where the cursor stands, in words; framed by the accent's color while it is pinned. */
private fun DrawScope.drawFlag(x: Float, text: String, isPinned: Boolean, letters: TextMeasurer, style: TextStyle, palette: Palette) {
    val layout = letters.measure(text, style, softWrap = false, maxLines = 1)
    val margin = GAP * density / 2
    val width = layout.size.width + 2 * margin
    val left = (x - width / 2).coerceIn(0f, maxOf(0f, size.width - width))
    val color = if (isPinned) palette.accent else palette.cursor
    drawRoundRect(color, Offset(left, 1f), Size(width, size.height - 3 * density), CornerRadius(3 * density))
    drawText(layout, topLeft = Offset(left + margin, (size.height - 2 * density - layout.size.height) / 2))
}

private const val HEIGHT = 24
private const val TEXTS = 64
private const val TICK = 4
private const val GAP = 12
private const val MAX_LETTERS = 60
