package badlog.viewer.graph.mark

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.drawscope.DrawScope
import badlog.analysis.EnabledSpan
import badlog.analysis.Span
import badlog.viewer.graph.plot.pixelOf
import badlog.viewer.theme.Palette

/** Shades where the robot was enabled, where [visible] is seen; its own control in another tint than a driver's. */
internal fun DrawScope.drawEnabled(enabled: List<EnabledSpan>, visible: Span, palette: Palette) {
    for (stretch in enabled) {
        if (stretch.span.to < visible.from || stretch.span.from > visible.to) continue
        drawBand(stretch.span, visible, enabledColor(stretch.isAutonomous, palette))
    }
}

/** Shades [span] where [visible] is seen. */
internal fun DrawScope.drawBand(span: Span, visible: Span, color: Color) {
    val left = pixelOf(span.from, visible, size.width).coerceIn(0f, size.width)
    val right = pixelOf(span.to, visible, size.width).coerceIn(0f, size.width)
    if (right > left) drawRect(color, Offset(left, 0f), Size(right - left, size.height))
}

private fun enabledColor(isAutonomous: Boolean, palette: Palette): Color {
    val base = if (isAutonomous) palette.line(4) else palette.line(2)
    return base.copy(alpha = if (palette.isDark) 0.10f else 0.07f)
}
