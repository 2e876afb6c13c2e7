package badlog.window.graph

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
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.input.pointer.PointerIcon
import androidx.compose.ui.input.pointer.pointerHoverIcon
import androidx.compose.ui.semantics.contentDescription
import androidx.compose.ui.semantics.semantics
import androidx.compose.ui.text.AnnotatedString
import androidx.compose.ui.text.TextMeasurer
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.drawText
import androidx.compose.ui.text.rememberTextMeasurer
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.sp
import badlog.core.analysis.Span
import badlog.viewer.draw.axis.Ticks
import badlog.viewer.session.gesture.PlotGestures
import badlog.viewer.shown.cursor.Cursors
import badlog.viewer.text.cursorText
import badlog.viewer.text.differenceText
import badlog.window.graph.plot.pixelOf
import badlog.window.graph.scene.GraphScene
import badlog.window.graph.scene.ViewTarget
import badlog.window.graph.scene.receives
import badlog.window.theme.LocalPalette
import badlog.window.theme.NameCut
import badlog.window.theme.Palette
import badlog.window.theme.measureName

/** The common x axis below the graphs, with the cursor's place; dragging it pans. */
@Composable
internal fun XAxisBar(scene: GraphScene) {
    val palette = LocalPalette.current
    val gestures = remember(scene) { PlotGestures(ViewTarget(scene), isAxis = true) }
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
                .receives(gestures)
                .drawBehind {
                    val axis = scene.current.recording?.view?.xAxis ?: return@drawBehind
                    val visible = scene.view.viewport.visible
                    drawPlaces(visible, axis.title, letters, style, palette)
                    val clocks = scene.current.recording?.clocks
                    for (flag in flagsOf(scene.view.cursors, palette)) {
                        if (flag.x !in visible) continue
                        val other = if (flag.isMain) clocks?.textAt(flag.x) else flag.from?.let { differenceText(it, flag.x, axis) }
                        val text = flag.name + cursorText(flag.x, axis, visible.width, other.orEmpty())
                        drawFlag(pixelOf(flag.x, visible, size.width), text, flag.color, letters, strong)
                    }
                },
        )
    }
}

private fun DrawScope.drawPlaces(visible: Span, title: String, letters: TextMeasurer, style: TextStyle, palette: Palette) {
    drawLine(palette.border, Offset.Zero, Offset(size.width, 0f))
    val room = (size.width / 4).toInt().coerceAtLeast(1)
    val name = letters.measureName(AnnotatedString(title.takeLast(MAX_LETTERS)), style, room, NameCut.BEGINNING)
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

/** A flag on the axis at [x], called [name]: with all clocks if [isMain], or else the distance from another cursor at [from]. */
private class Flag(val x: Double, val name: String, val color: Color, val isMain: Boolean, val from: Double? = null)

/** Returns the flags of [cursors], the more important ones last: pinned ones in the accent color. */
private fun flagsOf(cursors: Cursors, palette: Palette): List<Flag> {
    val (a, b, hover) = cursors
    return listOfNotNull(
        hover?.let { Flag(it, "", if (a == null) palette.cursor else palette.muted, isMain = a == null, from = a) },
        b?.let { Flag(it, "B ", palette.accent, isMain = false, from = a) },
        a?.let { Flag(it, if (b == null) "" else "A ", palette.accent, isMain = true) },
    )
}

/** Draws the text of a cursor's place. */
private fun DrawScope.drawFlag(x: Float, text: String, color: Color, letters: TextMeasurer, style: TextStyle) {
    val layout = letters.measure(text, style, softWrap = false, maxLines = 1)
    val margin = GAP * density / 2
    val width = layout.size.width + 2 * margin
    val left = (x - width / 2).coerceIn(0f, maxOf(0f, size.width - width))
    drawRoundRect(color, Offset(left, 1f), Size(width, size.height - 3 * density), CornerRadius(3 * density))
    drawText(layout, topLeft = Offset(left + margin, (size.height - 2 * density - layout.size.height) / 2))
}

private const val HEIGHT = 24
private const val TEXTS = 64
private const val TICK = 4
private const val GAP = 12
private const val MAX_LETTERS = 60
