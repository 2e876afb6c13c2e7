package badlog.viewer.graph

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.Path
import androidx.compose.ui.graphics.drawscope.DrawScope
import badlog.analysis.Event
import badlog.plot.Span
import badlog.viewer.app.Viewer
import badlog.viewer.theme.Palette
import kotlin.math.abs

/** The events that graphs and overview mark: those that are listed. */
internal fun visibleEvents(viewer: Viewer): List<Event> = viewer.matchingEvents.run { List(placedCount) { eventAt(it) } }

/** Those of some events that have a place on the x axis, in its order. */
internal class EventTimeline(events: List<Event>) {
    /** Them, ascending. */
    val events: List<Event> = events.filter { it.x.isFinite() }.sortedBy { it.x }

    private val positions = DoubleArray(this.events.size) { this.events[it].x }

    /** The event nearest to [x] if it is no further than [distance]; the earlier one of two. */
    fun nearest(x: Double, distance: Double): Event? {
        val after = firstAtOrAfter(x)
        return listOfNotNull(events.getOrNull(after - 1), events.getOrNull(after))
            .minByOrNull { abs(it.x - x) }
            ?.takeIf { abs(it.x - x) <= distance }
    }

    /**
     * The pixels, ascending, of [width] that show [span], on which events stand. Costs as much as there are pixels, however many
     * events there are.
     */
    fun pixels(span: Span, width: Int): IntArray {
        val pixels = IntArray(minOf(width + 1, positions.size))
        var count = 0
        var index = firstAtOrAfter(span.from)
        while (index < positions.size && positions[index] <= span.to && count < pixels.size) {
            val pixel = ((positions[index] - span.from) / span.width * width).toInt()
            // What was skipped to may be this pixel again, by rounding.
            if (count == 0 || pixels[count - 1] != pixel) pixels[count++] = pixel
            index = maxOf(index + 1, firstAtOrAfter(span.from + (pixel + 1) * span.width / width))
        }
        return pixels.copyOf(count)
    }

    private fun firstAtOrAfter(x: Double): Int {
        var low = 0
        var high = positions.size
        while (low < high) {
            val middle = (low + high) ushr 1
            if (positions[middle] < x) low = middle + 1 else high = middle
        }
        return low
    }
}

/** Draws the marks of [timeline] along the top, where [visible] is seen; with lines down to the bottom where those are few. */
internal fun DrawScope.drawEventMarks(timeline: EventTimeline, visible: Span, palette: Palette, hasLines: Boolean = true) {
    val pixels = timeline.pixels(visible, size.width.toInt())
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
