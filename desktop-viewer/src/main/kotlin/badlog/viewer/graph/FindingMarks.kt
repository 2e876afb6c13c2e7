package badlog.viewer.graph

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.geometry.Size
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.PathEffect
import androidx.compose.ui.graphics.drawscope.DrawScope
import androidx.compose.ui.graphics.drawscope.Fill
import androidx.compose.ui.graphics.drawscope.Stroke
import badlog.analysis.Span
import badlog.recording.Severity
import badlog.rules.Finding
import badlog.viewer.findings.findingColor
import badlog.viewer.theme.Palette

/**
 * Draws the marks of [findings] along the bottom, where [visible] is seen: a bar while one holds, and where to look first a diamond,
 * filled for an error, hollow for a warning, small for a note.
 */
internal fun DrawScope.drawFindings(findings: List<Finding>, visible: Span, palette: Palette) {
    val bar = BAR * density
    for (run in coveredPixels(findings, visible, size.width.toInt())) {
        val left = run.from.toFloat()
        drawRect(
            palette.findingColor(run.severity).copy(alpha = BAR_OPACITY),
            Offset(left, size.height - bar),
            Size(maxOf(run.until - left, density), bar),
        )
    }
    // The worst last, so that they lie on top.
    for (severity in Severity.entries) {
        var last = Float.NEGATIVE_INFINITY
        for (finding in findings) {
            if (finding.severity != severity || finding.time !in visible) continue
            val x = pixelOf(finding.time, visible, size.width)
            if (x - last < density) continue
            last = x
            drawDiamond(x, severity, palette)
        }
    }
}

private fun DrawScope.drawDiamond(x: Float, severity: Severity, palette: Palette) {
    val half = (if (severity == Severity.NOTE) SMALL else LARGE) * density
    val middle = size.height - LARGE * density - density
    val diamond = Path().apply {
        moveTo(x, middle - half)
        lineTo(x + half, middle)
        lineTo(x, middle + half)
        lineTo(x - half, middle)
        close()
    }
    val colour = palette.findingColor(severity)
    drawPath(diamond, if (severity == Severity.WARNING) palette.surface else colour, style = Fill)
    drawPath(diamond, if (severity == Severity.WARNING) colour else palette.surface, style = Stroke(1.5f * density))
}

/** Shades when [finding] holds over the whole height, between broken lines where there is room for them. */
internal fun DrawScope.drawShownFinding(finding: Finding, visible: Span, palette: Palette) {
    val colour = palette.findingColor(finding.severity)
    val broken = PathEffect.dashPathEffect(floatArrayOf(4 * density, 3 * density))
    fun edge(at: Double) {
        if (at !in visible) return
        val x = pixelOf(at, visible, size.width)
        drawLine(colour.copy(alpha = EDGE_OPACITY), Offset(x, 0f), Offset(x, size.height), density, pathEffect = broken)
    }
    for (span in finding.spans) {
        drawBand(span, visible, colour.copy(alpha = BAND_OPACITY))
        val isWide = span.width / visible.width * size.width >= LEAST_WIDTH * density
        if (isWide) edge(span.to)
        edge(span.from)
    }
    if (finding.spans.isEmpty()) edge(finding.time)
}

/** Neighbouring pixels, from [from] until [until], at which the worst finding that holds is of [severity]. */
internal class PixelRun(val from: Int, val until: Int, val severity: Severity)

/** On which of [width] pixels that show [visible] a finding holds. Costs little however many spans there are. */
internal fun coveredPixels(findings: List<Finding>, visible: Span, width: Int): List<PixelRun> {
    if (width <= 0) return emptyList()
    val worst = IntArray(width)
    for (finding in findings) {
        val rank = finding.severity.ordinal + 1
        for (span in finding.spans) {
            if (span.to < visible.from || span.from > visible.to) continue
            val from = pixelOf(span.from, visible, width.toFloat()).toInt().coerceIn(0, width - 1)
            val to = pixelOf(span.to, visible, width.toFloat()).toInt().coerceIn(0, width - 1)
            for (pixel in from..to) if (worst[pixel] < rank) worst[pixel] = rank
        }
    }
    val runs = ArrayList<PixelRun>()
    var from = 0
    for (pixel in 1..width) {
        if (pixel < width && worst[pixel] == worst[from]) continue
        if (worst[from] > 0) runs += PixelRun(from, pixel, Severity.entries[worst[from] - 1])
        from = pixel
    }
    return runs
}

private const val BAR = 3
private const val BAR_OPACITY = 0.55f
private const val LARGE = 5
private const val SMALL = 3
private const val BAND_OPACITY = 0.12f
private const val EDGE_OPACITY = 0.6f
private const val LEAST_WIDTH = 6
