package badlog.window.graph.mark

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.PathEffect
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Stroke
import badlog.core.analysis.Span
import badlog.core.recording.Severity
import badlog.rules.Finding
import badlog.viewer.draw.mark.FindingGlyph
import badlog.viewer.draw.mark.FindingMarks
import badlog.viewer.draw.mark.FindingTimeline
import badlog.window.findings.findingColor
import badlog.window.graph.plot.pixelOf
import badlog.window.theme.Palette

/**
 * Draws the marks of [findings] along the bottom, where [visible] is seen: a bar while one lasts, and a glyph where it begins.
 *
 * @param marks are recalculated; callers that draw repeatedly should reuse them.
 */
internal fun DrawScope.drawFindings(findings: FindingTimeline<Finding>?, marks: FindingMarks, visible: Span, palette: Palette) {
    if (findings == null) return
    marks.place(findings, visible, size.width.toDouble(), density.toDouble())
    val bar = BAR * density
    for (i in 0 until marks.runCount) {
        val severity = marks.runSeverity(i) ?: continue
        val left = marks.runFrom(i).toFloat()
        val width = marks.runTo(i).toFloat() - left
        drawRect(palette.findingColor(severity).copy(alpha = BAR_OPACITY), Offset(left, size.height - bar), Size(width, bar))
    }
    for (i in 0 until marks.size) drawGlyph(marks.pixelOf(i).toFloat(), marks.severityOf(i), palette)
}

private fun DrawScope.drawGlyph(x: Float, severity: Severity, palette: Palette) {
    val glyph = FindingGlyph.of(severity)
    val reach = FindingGlyph.SIZE.toFloat() * density
    val middle = size.height - reach - density
    val color = palette.findingColor(severity)
    val stroke = Stroke(1.5f * density)
    if (glyph.isHollow) {
        val center = Offset(x, middle)
        drawCircle(palette.surface, reach - density, center)
        drawCircle(color, reach - density, center, style = stroke)
        return
    }
    val path = Path()
    for (at in glyph.outline.indices step 2) {
        val cornerX = x + glyph.outline[at].toFloat() * reach
        val cornerY = middle + glyph.outline[at + 1].toFloat() * reach
        if (at == 0) path.moveTo(cornerX, cornerY) else path.lineTo(cornerX, cornerY)
    }
    path.close()
    drawPath(path, color)
    drawPath(path, palette.surface, style = Stroke(density))
}

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

private const val BAR = 3
private const val BAR_OPACITY = 0.55f
private const val BAND_OPACITY = 0.12f
private const val EDGE_OPACITY = 0.6f
private const val MIN_WIDTH = 6
