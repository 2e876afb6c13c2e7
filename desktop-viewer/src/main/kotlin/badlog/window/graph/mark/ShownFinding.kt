package badlog.window.graph.mark

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Color
import androidx.compose.ui.graphics.PathEffect
import androidx.compose.ui.graphics.drawscope.DrawScope
import badlog.core.analysis.Span
import badlog.rules.Finding
import badlog.window.findings.findingColor
import badlog.window.graph.plot.pixelOf
import badlog.window.theme.Palette

/** Shades the time when [finding] holds over the whole height, between dashed lines if there is room for them. */
internal fun DrawScope.drawShownFinding(finding: Finding, visible: Span, palette: Palette) {
    val color = palette.findingColor(finding.severity)
    val broken = PathEffect.dashPathEffect(floatArrayOf(4 * density, 3 * density))
    fun edge(at: Double) {
        if (at !in visible) return
        val x = pixelOf(at, visible, size.width)
        drawLine(color.copy(alpha = EDGE_OPACITY), Offset(x, 0f), Offset(x, size.height), density, pathEffect = broken)
    }
    for (span in finding.spans) {
        drawBand(span, visible, color.copy(alpha = BAND_OPACITY))
        val isWide = span.width / visible.width * size.width >= MIN_WIDTH * density
        if (isWide) edge(span.to)
        edge(span.from)
    }
    if (finding.spans.isEmpty()) edge(finding.time)
}

/** Shades [span] where [visible] is seen. */
internal fun DrawScope.drawBand(span: Span, visible: Span, color: Color) {
    val left = pixelOf(span.from, visible, size.width).coerceIn(0f, size.width)
    val right = pixelOf(span.to, visible, size.width).coerceIn(0f, size.width)
    if (right > left) drawRect(color, Offset(left, 0f), Size(right - left, size.height))
}

private const val BAND_OPACITY = 0.12f
private const val EDGE_OPACITY = 0.6f
private const val MIN_WIDTH = 6
