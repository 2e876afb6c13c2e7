package badlog.viewer.draw.mark

import badlog.core.analysis.Span
import badlog.core.recording.Severity
import badlog.viewer.choices.note.Note
import kotlin.math.abs
import kotlin.math.floor

/**
 * The mark of a finding of one severity on the time axis.
 *
 * @property outline the corners, alternating x and y, from -1 to 1; y points down. Empty for a circle.
 * @property isHollow whether only the outline is drawn.
 */
enum class FindingGlyph(val outline: DoubleArray, val isHollow: Boolean) {
    /** The mark of an error. */
    DIAMOND(doubleArrayOf(0.0, -1.0, 1.0, 0.0, 0.0, 1.0, -1.0, 0.0), isHollow = false),

    /** The mark of a warning. */
    TRIANGLE(doubleArrayOf(0.0, -1.0, 1.0, 1.0, -1.0, 1.0), isHollow = false),

    /** The mark of a note: a ring, somewhat smaller. */
    RING(doubleArrayOf(), isHollow = true),
    ;

    companion object {
        /** The extent of a glyph from its center, in CSS pixels or dp. */
        const val SIZE: Double = 4.5

        /** Returns the mark of a finding of [severity]. */
        fun of(severity: Severity): FindingGlyph = when (severity) {
            Severity.ERROR -> DIAMOND
            Severity.WARNING -> TRIANGLE
            Severity.NOTE -> RING
        }
    }
}

/**
 * The marks of findings on a time axis, in drawing order, the worst last. The start of a place has a glyph, sometimes with a line; glyphs
 * of one severity that would hide each other are merged. Findings that last also have runs of pixels. The arrays are reused for the next
 * drawing.
 */
class FindingMarks {
    private var pixels = DoubleArray(0)
    private var looks = IntArray(0)
    private var worst = IntArray(0)
    private var runEnds = IntArray(0)
    private var onePixel = 1.0

    var size: Int = 0
        private set

    var runCount: Int = 0
        private set

    /** Returns the place of glyph [index], in pixels from the left. */
    fun pixelOf(index: Int): Double = pixels[index]

    /** Returns the severity of glyph [index]. */
    fun severityOf(index: Int): Severity = Severity.entries[looks[index] / 2]

    /** Returns whether glyph [index] has room for a line: a crowd of lines would hide the graph. */
    fun hasLine(index: Int): Boolean = looks[index] % 2 == 1

    /** Returns the start of run [index], in pixels from the left. */
    fun runFrom(index: Int): Double = (if (index == 0) 0 else runEnds[index - 1]) * onePixel

    /** Returns the end of run [index], in pixels from the left. */
    fun runTo(index: Int): Double = runEnds[index] * onePixel

    /** Returns the worst severity found over run [index]; null if nothing was found there. */
    fun runSeverity(index: Int): Severity? = Severity.entries.getOrNull(worst[runEnds[index] - 1] - 1)

    /** Finds the marks of the [findings] in [span], over [width] physical pixels; a CSS pixel or dp is [onePixel] of them. */
    fun place(findings: FindingTimeline<*>, span: Span, width: Double, onePixel: Double) {
        this.onePixel = onePixel
        size = 0
        runCount = 0
        val columns = maxOf(0, floor(width / onePixel).toInt())
        if (columns == 0 || findings.places.isEmpty() || !(span.width > 0)) return
        cover(findings, span, columns)
        for (severity in Severity.entries) {
            var last = Double.NEGATIVE_INFINITY
            var lastLine = Double.NEGATIVE_INFINITY
            for (place in findings.places) {
                if (place.span.from > span.to) break
                if (place.severity != severity || place.span.from < span.from) continue
                val pixel = floor((place.span.from - span.from) / span.width * columns) * onePixel
                if (pixel - last < CROWDED * onePixel) continue
                last = pixel
                val hasLine = pixel - lastLine >= APART * onePixel
                if (hasLine) lastLine = pixel
                add(pixel, severity.ordinal * 2 + if (hasLine) 1 else 0)
            }
        }
    }

    private fun add(pixel: Double, look: Int) {
        if (size == pixels.size) {
            pixels = pixels.copyOf(maxOf(FIRST_MARKS, size * 2))
            looks = looks.copyOf(pixels.size)
        }
        pixels[size] = pixel
        looks[size++] = look
    }

    private fun cover(findings: FindingTimeline<*>, span: Span, columns: Int) {
        if (worst.size != columns) {
            worst = IntArray(columns)
            runEnds = IntArray(columns)
        }
        worst.fill(0)
        for (place in findings.places) {
            if (place.span.from > span.to) break
            if (place.span.to < span.from || place.span.width <= 0) continue
            val from = columnOf(place.span.from, span, columns)
            val to = columnOf(place.span.to, span, columns)
            val rank = place.severity.ordinal + 1
            for (column in from..to) if (worst[column] < rank) worst[column] = rank
        }
        for (column in 1..columns) if (column == columns || worst[column] != worst[column - 1]) runEnds[runCount++] = column
    }

    private fun columnOf(x: Double, span: Span, columns: Int) =
        floor((x - span.from) / span.width * columns).coerceIn(0.0, columns - 1.0).toInt()
}

/** The maximum distance between a cursor and a mark that it points at, as a fraction of the visible width. */
const val MARK_REACH: Double = 0.008

/** The [text] of the mark of a note or an event at [x]. */
class MarkText(val x: Double, val text: String)

/**
 * Returns the mark that a cursor at [x] points at in [visible]: the nearest one of [notes], otherwise of [events]. Null if there is none.
 */
fun markNear(x: Double, visible: Span, notes: List<Note>, events: EventTimeline): MarkText? {
    val reach = visible.width * MARK_REACH
    val note = notes.minByOrNull { abs(it.x - x) }?.takeIf { abs(it.x - x) <= reach }
    if (note != null) return MarkText(note.x, note.text)
    return events.nearest(x, reach)?.let { MarkText(it.x, it.text) }
}

/**
 * The distance below which two glyphs are merged, in CSS pixels or dp. Drawing a thousand of them would take a whole frame, and
 * show nothing more.
 */
private const val CROWDED = 4

/** The minimum distance between two lines, in CSS pixels or dp. */
private const val APART = 9
private const val FIRST_MARKS = 16
