package badlog.page.graph

import badlog.analysis.Span
import badlog.page.view.EventTimeline
import kotlin.math.floor

/**
 * The mark of one or more events that share a pixel.
 *
 * @property pixel where it stands, from the frame's left edge.
 * @property isSerious whether one of them is an error or a warning.
 * @property hasHead whether it is more than a tick.
 * @property hasLine whether a line runs down from it.
 */
internal class EventMark(val pixel: Double, val isSerious: Boolean, val hasHead: Boolean, val hasLine: Boolean)

/**
 * The marks of the events of [span] on [width] pixels, [onePixel] of which are one of the page: those that crowd behind
 * another are ticks, so that a chatty robot does not hide its graphs. What is serious keeps its head in any crowd.
 */
internal fun eventMarks(timeline: EventTimeline, span: Span, width: Double, onePixel: Double): List<EventMark> {
    val pixels = ArrayList<Double>()
    val isSerious = ArrayList<Boolean>()
    for (i in timeline.firstAtOrAfter(span.from) until timeline.events.size) {
        val x = timeline.events[i].x
        if (x > span.to) break
        val pixel = floor((x - span.from) / span.width * width)
        if (pixels.isNotEmpty() && pixel - pixels.last() < onePixel) {
            if (timeline.isSerious(i)) isSerious[isSerious.size - 1] = true
        } else {
            pixels += pixel
            isSerious += timeline.isSerious(i)
        }
    }
    val apart = FEWEST_PIXELS_APART * onePixel
    var lastLine = Double.NEGATIVE_INFINITY
    return pixels.indices.map { i ->
        val pixel = pixels[i]
        val isCrowded = (i > 0 && pixel - pixels[i - 1] < apart) ||
            (i + 1 < pixels.size && isSerious[i + 1] && pixels[i + 1] - pixel < apart)
        val hasLine = if (isSerious[i]) pixel - lastLine >= apart else !isCrowded
        if (hasLine) lastLine = pixel
        EventMark(pixel, isSerious[i], isSerious[i] || !isCrowded, hasLine)
    }
}

private const val FEWEST_PIXELS_APART = 9
