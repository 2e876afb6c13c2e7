package badlog.window.graph.mark

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.text.TextMeasurer
import androidx.compose.ui.text.TextStyle
import androidx.compose.ui.text.drawText
import androidx.compose.ui.unit.sp
import badlog.core.analysis.Span
import badlog.viewer.draw.color.modeOpacity
import badlog.viewer.draw.mark.ModeBands
import badlog.viewer.draw.mark.ModeTimeline
import badlog.window.graph.plot.pixelOf
import badlog.window.theme.Palette

/** Shades where the robot was enabled, by its mode, where [visible] is seen; with the names of modes where [letters] have room. */
internal fun DrawScope.drawModes(modes: ModeTimeline?, bands: ModeBands, visible: Span, palette: Palette, letters: TextMeasurer? = null) {
    if (modes == null) return
    bands.place(modes, visible, size.width.toDouble())
    for (i in 0 until bands.size) {
        val left = bands.leftOf(i).toFloat()
        val width = (bands.rightOf(i) - bands.leftOf(i)).toFloat()
        val color = palette.mode(bands.modeOf(i)).copy(alpha = modeOpacity(palette.isDark).toFloat())
        drawRect(color, Offset(left, 0f), Size(width, size.height))
        val name = letters?.measure(bands.modeOf(i).title, TextStyle(color = palette.muted, fontSize = LETTERS.sp)) ?: continue
        if (name.size.width + 2 * MARGIN * density > width) continue
        drawText(name, topLeft = Offset(left + MARGIN * density, size.height - name.size.height))
    }
}

/** Shades [span] where [visible] is seen. */
internal fun DrawScope.drawBand(span: Span, visible: Span, color: Color) {
    val left = pixelOf(span.from, visible, size.width).coerceIn(0f, size.width)
    val right = pixelOf(span.to, visible, size.width).coerceIn(0f, size.width)
    if (right > left) drawRect(color, Offset(left, 0f), Size(right - left, size.height))
}

private const val LETTERS = 11
private const val MARGIN = 5
