package badlog.viewer.graph

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.drawscope.DrawScope
import badlog.analysis.Span
import badlog.viewer.recording.MatchingEvents
import badlog.viewer.theme.Palette

/** Draws the marks of [events] along the top, where [visible] is seen; with lines down to the bottom where those are few. */
internal fun DrawScope.drawEventMarks(events: MatchingEvents, visible: Span, palette: Palette, hasLines: Boolean = true) {
    val pixels = events.pixels(visible, size.width.toInt())
    if (pixels.isEmpty()) return
    val head = HEAD * density
    val heads = Path()
    var last = Float.NEGATIVE_INFINITY
    for (pixel in pixels) {
        val x = pixel + 0.5f
        if (hasLines && pixels.size <= MOST_LINES) {
            drawLine(palette.event.copy(alpha = LINE_OPACITY), Offset(x, 0f), Offset(x, size.height))
        }
        // Heads that lie on one another would be a bar: only the first is drawn, and ticks after it.
        if (x - last < head) {
            drawLine(palette.event, Offset(x, 0f), Offset(x, head))
            continue
        }
        last = x
        heads.moveTo(x - head, 0f)
        heads.lineTo(x + head, 0f)
        heads.lineTo(x, head * 1.5f)
        heads.close()
    }
    drawPath(heads, palette.event)
}

private const val HEAD = 3.5f
private const val LINE_OPACITY = 0.25f
private const val MOST_LINES = 80
