package badlog.viewer.draw.figure

import badlog.viewer.draw.color.PenColors
import badlog.viewer.draw.color.Shade
import badlog.viewer.draw.pen.Pen
import badlog.viewer.draw.pen.fittedStart

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
