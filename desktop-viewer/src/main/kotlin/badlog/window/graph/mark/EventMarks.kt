package badlog.window.graph.mark

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.drawscope.DrawScope
import badlog.core.analysis.Span
import badlog.viewer.draw.mark.EventMarks
import badlog.viewer.draw.mark.EventTimeline
import badlog.window.theme.Palette

/** Draws the marks of [events] along the top, where [visible] is seen; those that have one with a line down to the bottom. */
internal fun DrawScope.drawEventMarks(events: EventTimeline, visible: Span, palette: Palette, hasLines: Boolean = true) {
    val marks = EventMarks()
    marks.place(events, visible, size.width.toDouble(), density.toDouble())
    val head = HEAD * density
    val heads = Path()
    for (i in 0 until marks.size) {
        val x = marks.pixelOf(i).toFloat() + 0.5f
        if (hasLines && marks.hasLine(i)) {
            val opacity = if (marks.isSerious(i)) SERIOUS_OPACITY else LINE_OPACITY
            drawLine(palette.event.copy(alpha = opacity), Offset(x, 0f), Offset(x, size.height))
        }
        if (marks.hasHead(i)) {
            heads.moveTo(x - head, 0f)
            heads.lineTo(x + head, 0f)
            heads.lineTo(x, head * 1.5f)
            heads.close()
        } else {
            drawLine(palette.event.copy(alpha = SERIOUS_OPACITY), Offset(x, 0f), Offset(x, head), strokeWidth = density)
        }
    }
    drawPath(heads, palette.event)
}

private const val HEAD = 3.5f
private const val LINE_OPACITY = 0.25f
private const val SERIOUS_OPACITY = 0.5f
