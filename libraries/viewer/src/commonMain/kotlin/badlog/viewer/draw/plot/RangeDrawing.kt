package badlog.viewer.draw.plot

import badlog.core.analysis.Span
import badlog.rules.Finding
import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.color.faded
import badlog.viewer.draw.pen.Pen
import badlog.viewer.draw.pen.Points

/** Draws [range], a selected part of x, as a band over the height of [frame], with its edges. */
fun Pen.drawSelection(frame: PlotFrame, range: Span, colors: PenColors) {
    drawBand(frame, range, faded(colors[Shade.ACCENT], SELECTED_OPACITY))
    val edges = Points()
    for (edge in listOf(range.from, range.to)) {
        if (edge in frame.shown) frame.x.placeOf(edge).let { edges.line(it, frame.top, it, frame.bottom) }
    }
    segments(edges, colors[Shade.ACCENT], density)
}

/** Draws a selected part of y, from [top] to [bottom] in pixels, as a band over the width of [frame], with its edges. */
fun Pen.drawSelectedHeights(frame: PlotFrame, top: Double, bottom: Double, colors: PenColors) {
    rectangle(frame.left, top, frame.width, bottom - top, faded(colors[Shade.ACCENT], SELECTED_OPACITY))
    val edges = Points().line(frame.left, top, frame.right, top).line(frame.left, bottom, frame.right, bottom)
    segments(edges, colors[Shade.ACCENT], density)
}

/** Shades the time of [finding] over the height of [frame], between dashed lines if there is room for them. */
fun Pen.drawFinding(frame: PlotFrame, finding: Finding, colors: PenColors) {
    val color = colors.severity(finding.severity)
    val edges = Points()

    fun edge(x: Double) {
        if (x in frame.shown) frame.x.placeOf(x).let { edges.line(it, frame.top, it, frame.bottom) }
    }
    for (span in finding.spans) {
        drawBand(frame, span, faded(color, FOUND_OPACITY))
        if (span.width / frame.shown.width * frame.width >= MIN_FOUND_WIDTH * density) edge(span.to)
        edge(span.from)
    }
    if (finding.spans.isEmpty()) edge(finding.time)
    segments(edges, faded(color, EDGE_OPACITY), density, DASH * density)
}

/** Draws the [visible] part of a log as an outline with handles, and shades the rest. [frame] shows the whole log. */
fun Pen.drawVisible(frame: PlotFrame, visible: Span, colors: PenColors) {
    val least = MIN_WIDTH * density
    val center = frame.x.placeOf(visible.from + visible.width / 2)
    val half = maxOf(frame.x.placeOf(visible.to) - center, least / 2)
    val left = center - half
    val right = center + half
    val shade = faded(colors[Shade.PAGE], SHADED_OPACITY)
    rectangle(frame.left, frame.top, maxOf(0.0, left - frame.left), frame.height, shade)
    rectangle(right, frame.top, maxOf(0.0, frame.right - right), frame.height, shade)
    val outline = roundedBox(left, frame.top + 0.5, right - left, frame.height - 1, RADIUS * density)
    chain(outline, isClosed = true, colors[Shade.ACCENT], OUTLINE * density)
    // Only with room between the edges for handles.
    if (right - left < 4 * least) return
    val handles = Points()
    for (edge in listOf(left, right)) {
        handles.line(edge, frame.top + HANDLE_FROM * frame.height, edge, frame.top + (1 - HANDLE_FROM) * frame.height)
    }
    segments(handles, colors[Shade.ACCENT], HANDLE * density)
}

private fun Pen.drawBand(frame: PlotFrame, span: Span, color: Int) {
    val left = frame.x.placeOf(span.from).coerceIn(frame.left, frame.right)
    val right = frame.x.placeOf(span.to).coerceIn(frame.left, frame.right)
    if (right > left) rectangle(left, frame.top, right - left, frame.height, color)
}

private const val SELECTED_OPACITY = 0.16
private const val FOUND_OPACITY = 0.12
private const val EDGE_OPACITY = 0.6
private const val SHADED_OPACITY = 0.65
private const val DASH = 4.0
private const val MIN_WIDTH = 5
private const val MIN_FOUND_WIDTH = 6
private const val RADIUS = 3.0
private const val OUTLINE = 1.5
private const val HANDLE = 4.0
private const val HANDLE_FROM = 0.3
