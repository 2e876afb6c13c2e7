package badlog.viewer.draw.mark

import badlog.core.analysis.Span
import kotlin.math.floor

/**
 * The marks of events on a time line, each for one or more events that share a pixel. A mark is a head with a line below it, or a tick for
 * events that crowd behind another one, so that a chatty robot does not hide its graphs. Errors and warnings always have heads. The arrays
 * are reused for the next drawing.
 */
class EventMarks {
    private var pixels = DoubleArray(0)
    private var looks = IntArray(0)

    var size: Int = 0
        private set

    /** Returns the place of mark [index], in pixels from the left. */
    fun pixelOf(index: Int): Double = pixels[index]

    /** Returns whether one of the events of mark [index] is an error or a warning. */
    fun isSerious(index: Int): Boolean = looks[index] and SERIOUS != 0

    /** Returns whether mark [index] has a head; otherwise it is a tick. */
    fun hasHead(index: Int): Boolean = looks[index] and HEAD != 0

    /** Returns whether a line runs down from mark [index]. */
    fun hasLine(index: Int): Boolean = looks[index] and LINE != 0

    /**
     * Finds the marks of the [events] in [span], over [width] physical pixels; a CSS pixel or dp is [onePixel] of them. The cost depends on
     * the number of pixels, not of events.
     */
    fun place(events: EventTimeline, span: Span, width: Double, onePixel: Double) {
        size = 0
        val columns = floor(width / onePixel)
        if (!(columns >= 1) || !(span.width > 0)) return
        var index = events.firstAtOrAfter(span.from)
        while (index < events.placedCount && events.x[index] <= span.to) {
            val column = floor((events.x[index] - span.from) / span.width * columns)
            val next = maxOf(index + 1, minOf(events.firstAtOrAfter(span.from + (column + 1) * span.width / columns), events.placedCount))
            val until = if (column >= columns) events.placedCount else next
            add(column * onePixel, events.areSerious(index, until))
            index = until
        }
        look(APART * onePixel)
    }

    private fun add(pixel: Double, isSerious: Boolean) {
        // Because of rounding, the next event may be in this pixel again.
        val isSame = size > 0 && pixels[size - 1] == pixel
        if (!isSame && size++ == pixels.size) {
            pixels = pixels.copyOf(maxOf(FIRST_MARKS, size * 2))
            looks = looks.copyOf(pixels.size)
        }
        pixels[size - 1] = pixel
        looks[size - 1] = (if (isSame) looks[size - 1] else 0) or if (isSerious) SERIOUS else 0
    }

    private fun look(apart: Double) {
        var lastLine = Double.NEGATIVE_INFINITY
        for (i in 0 until size) {
            val isCrowded = (i > 0 && pixels[i] - pixels[i - 1] < apart) ||
                (i + 1 < size && isSerious(i + 1) && pixels[i + 1] - pixels[i] < apart)
            if (isSerious(i) || !isCrowded) looks[i] = looks[i] or HEAD
            if (if (isSerious(i)) pixels[i] - lastLine >= apart else !isCrowded) {
                looks[i] = looks[i] or LINE
                lastLine = pixels[i]
            }
        }
    }

    private companion object {
        const val SERIOUS = 1
        const val HEAD = 2
        const val LINE = 4

        /** The minimum distance between two heads or lines, in CSS pixels or dp. */
        const val APART = 9
        const val FIRST_MARKS = 64
    }
}
