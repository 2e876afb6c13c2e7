package badlog.viewer.draw.figure

import badlog.core.analysis.Span
import badlog.core.analysis.XAxis
import badlog.core.recording.Severity
import badlog.rules.Finding
import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.mark.Clocks
import badlog.viewer.draw.mark.FindingTimeline
import badlog.viewer.draw.pen.Pen
import badlog.viewer.draw.pen.fittedStart
import badlog.viewer.shown.cursor.Cursors
import badlog.viewer.text.countText
import badlog.viewer.text.cursorText
import badlog.viewer.text.differenceText
import badlog.viewer.text.placeText
import badlog.viewer.text.withUnit
import badlog.viewer.text.word

/**
 * Draws a self-explanatory figure. At the top is the [title], usually the log's name, with the visible range and the cursor. The [parts]
 * follow, which draw themselves one below the other. At the bottom are the findings in the range.
 */
fun Sheet.figure(title: String, notes: FigureNotes, parts: List<(Sheet) -> Unit>) {
    line(HEADING)
    text(title, TITLE, PenColors.LIGHT[Shade.TEXT], isBold = true)
    line(LINE)
    text(notes.place, LETTERS)
    for (part in parts) part(this)
    space(GAP)
    for (finding in notes.findings) {
        line(LINE)
        text(finding.head, LETTERS, PenColors.LIGHT.severity(finding.severity), isBold = true)
        text(finding.text, LETTERS)
    }
    if (notes.moreFindings == 0) return
    line(LINE)
    text("${countText(notes.moreFindings, "more finding")} in this range", LETTERS)
}

/**
 * An entry of a figure's legend.
 *
 * @property text the name of the line, and its value at the cursor.
 * @property color the index of the line's color; null if it has none.
 */
class LegendEntry(val text: String, val color: Int?)

/** Writes the title of a graph with its [unit], and its [legend]. */
fun Sheet.graphHead(title: String, unit: String, legend: List<LegendEntry>) {
    line(GRAPH_HEADING)
    text(if (unit.isEmpty()) title else "$title ($unit)", GRAPH_TITLE, PenColors.LIGHT[Shade.TEXT], isBold = true)
    if (legend.isNotEmpty()) line(LINE)
    for (entry in legend) {
        if (!hasRoomFor(entry.text, LETTERS)) line(LINE)
        entry.color?.let { swatch(PenColors.LIGHT.line(it)) }
        text(entry.text, LETTERS)
    }
    space(GAP)
}

/** Writes the title of the x axis below a graph. */
fun Sheet.xTitle(title: String) {
    space(GAP)
    textAtRight(title, LETTERS)
}

private const val HEADING = 26.0
private const val TITLE = 15.0
private const val LINE = 18.0
private const val LETTERS = 12.0
private const val GAP = 6.0
private const val GRAPH_HEADING = 24.0
private const val GRAPH_TITLE = 13.0

/**
 * The sheet on which a figure is drawn from top to bottom, in the colors of paper. Its lengths are in CSS pixels.
 *
 * @property width the width of the sheet.
 * @property pen the pen; [Pen.density] of its pixels are one CSS pixel.
 */
class Sheet(val width: Int, val pen: Pen) {
    private val density = pen.density

    /** The top of the next part. */
    var top: Double = 0.0
        private set

    /** The left end of the next [text] in a line. */
    private var left = MARGIN

    /** The height of the drawn parts, with a margin. */
    val height: Double get() = top + GAP

    /** Leaves a space of this height. */
    fun space(high: Double) {
        top += high
    }

    /** Begins a line of text of this height. */
    fun line(high: Double) {
        top += high
        left = MARGIN
    }

    /** Writes [text] at the current place in the line, with a font size of [letters]. The text is cut off at the edge of the sheet. */
    fun text(text: String, letters: Double, color: Int = PenColors.LIGHT[Shade.MUTED], isBold: Boolean = false) {
        val size = letters * density
        val shown = pen.fittedStart(text, maxOf(0.0, width - MARGIN - left) * density, size, isBold)
        pen.text(shown, left * density, (top - letters * RISE) * density, size, color, isBold = isBold)
        left += pen.widthOf(shown, size, isBold) / density + GAP
    }

    /** Writes [text] at the right edge of the current line. */
    fun textAtRight(text: String, letters: Double) {
        left = maxOf(MARGIN, width - 2 * MARGIN - widthOf(text, letters))
        text(text, letters)
    }

    /** Returns whether [text] fits into the rest of the line. */
    fun hasRoomFor(text: String, letters: Double): Boolean = left + widthOf(text, letters) + 2 * letters <= width

    private fun widthOf(text: String, letters: Double) = pen.widthOf(text, letters * density) / density

    /** Draws a square in [color] before the next text. */
    fun swatch(color: Int) {
        pen.rectangle(left * density, (top - SWATCH) * density, SWATCH * density, SWATCH * density, color)
        left += SWATCH + GAP / 2
    }

    /** Draws a part of this height with [draw], at the current place on the sheet. */
    fun part(high: Double, draw: (Pen) -> Unit) {
        pen.moved(0.0, top * density) { draw(pen) }
        top += high
    }

    companion object {
        /** The width of a page of paper between its margins. */
        const val PAPER: Int = 720

        private const val MARGIN = 12.0
        private const val GAP = 8.0
        private const val SWATCH = 10.0

        /** The height of the middle of small letters above the line's bottom, as a fraction of the font size. */
        private const val RISE = 0.35
    }
}

/**
 * The texts of an exported figure besides its graphs, which make it self-explanatory.
 *
 * @property place the file, the visible range and the cursors' places, in one line.
 * @property findings the findings in that range, the worst first, at most [MAX_NAMED].
 * @property moreFindings the number of further findings in that range.
 */
class FigureNotes private constructor(val place: String, val findings: List<NamedFinding>, val moreFindings: Int) {
    companion object {
        /** The maximum number of findings with their texts: more would take more room than the graphs. */
        const val MAX_NAMED: Int = 8

        /**
         * Returns the notes of a figure of [visible] on [axis]. [fileName] is empty if the title already has it; [found] is null if the
         * findings are unknown.
         */
        fun of(
            fileName: String,
            axis: XAxis,
            visible: Span,
            cursors: Cursors,
            clocks: Clocks,
            found: FindingTimeline<Finding>?,
        ): FigureNotes {
            fun at(x: Double) = placeText(x, axis, visible.width)
            val second = cursors.second
            val place = listOfNotNull(
                fileName.ifEmpty { null },
                "${at(visible.from)} – ${withUnit(at(visible.to), axis.unit)}",
                cursors.x?.let { "cursor at ${cursorText(it, axis, visible.width, clocks.textAt(it))}" },
                second?.let { "B at ${withUnit(at(it), axis.unit)}, ${differenceText(cursors.x ?: it, it, axis)}" },
            ).joinToString(" · ")
            val seen = found?.worstFirst.orEmpty().mapNotNull { finding ->
                val span = finding.places.firstOrNull { it.from <= visible.to && it.to >= visible.from } ?: return@mapNotNull null
                val head = "${finding.severity.word} · ${withUnit(at(span.from), axis.unit)}"
                NamedFinding(finding.severity, head, "${finding.rule}: ${finding.textAt(span)}")
            }
            return FigureNotes(place, seen.take(MAX_NAMED), maxOf(0, seen.size - MAX_NAMED))
        }
    }
}

/**
 * A finding in a figure.
 *
 * @property head the severity and the first place in the visible range: `error · 93.71 s`.
 * @property text the rule, and its finding at that place.
 */
class NamedFinding internal constructor(val severity: Severity, val head: String, val text: String)
