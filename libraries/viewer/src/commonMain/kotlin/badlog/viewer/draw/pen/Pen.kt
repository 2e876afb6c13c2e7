package badlog.viewer.draw.pen

import badlog.viewer.draw.curve.Strokes

/**
 * A surface for drawing: a browser's canvas, Skia, SVG. The common parts of page, window, figures and reports are drawn on one.
 *
 * Places and lengths are in physical pixels, x to the right and y down, from the pen's origin. Colors are `0xAARRGGBB`. Callers calculate
 * all places: a pen measures only texts.
 */
interface Pen {
    /** The number of physical pixels in one CSS pixel or dp. */
    val density: Double

    /** Draws [strokes] as lines of this [width]; 0 is one physical pixel, which is many times faster. A [dash] of 0 is solid. */
    fun lines(strokes: Strokes, color: Int, width: Double, dash: Double = 0.0)

    /** Fills the areas between [strokes] and the height [baseline]. */
    fun areas(strokes: Strokes, baseline: Double, color: Int)

    /** Draws separate lines of this [width]. Each four numbers of [ends] are x and y of both ends. A [dash] of 0 is solid. */
    fun segments(ends: Points, color: Int, width: Double, dash: Double = 0.0)

    /** Draws the line through all of [places], back to the first one if it [isClosed]. */
    fun chain(places: Points, isClosed: Boolean, color: Int, width: Double)

    /** Fills areas with [corners] corners each; [places] has the corners of all areas, one after the other. */
    fun shapes(places: Points, corners: Int, color: Int)

    /** Fills a circle of [radius] at each of [places]. */
    fun dots(places: Points, radius: Double, color: Int)

    /** Draws a circle with a line of this [width]. */
    fun ring(x: Double, y: Double, radius: Double, color: Int, width: Double)

    /** Fills a rectangle. */
    fun rectangle(left: Double, top: Double, width: Double, height: Double, color: Int)

    /**
     * Writes [text] on the given [side] of [x], with its small letters around the height [middle].
     *
     * @param letters the font size.
     * @param halo the color of an outline that separates the text from its background; null if there is none.
     */
    fun text(
        text: String,
        x: Double,
        middle: Double,
        letters: Double,
        color: Int,
        side: TextSide = TextSide.RIGHT,
        isBold: Boolean = false,
        halo: Int? = null,
    )

    /** Returns the width of [text] with a font size of [letters]. */
    fun widthOf(text: String, letters: Double, isBold: Boolean = false): Double

    /** Draws [image] with [opacity]. */
    fun image(image: PenImage, left: Double, top: Double, width: Double, height: Double, opacity: Double)

    /** Draws only the part of [draw] within the rectangle. */
    fun clip(left: Double, top: Double, width: Double, height: Double, draw: () -> Unit)

    /** Draws [draw] with its origin at ([x], [y]). */
    fun moved(x: Double, y: Double, draw: () -> Unit)

    /**
     * Draws a layer that many graphs share. A pen may draw it once and copy it while [key] stays the same.
     *
     * @param name identifies the layer among the shared ones.
     * @param draw receives a pen and a height, and draws the layer at the pen's origin in that height; if the drawing is higher, only its
     *   bottom is shown.
     */
    fun layer(name: String, left: Double, top: Double, width: Double, height: Double, key: List<Any?>, draw: (Pen, Double) -> Unit): Unit =
        moved(left, top) { draw(this, height) }
}

/** The side of a place on which a text is written. */
enum class TextSide {
    /** The text ends at the place. */
    LEFT,

    /** The middle of the text is at the place. */
    CENTER,

    /** The text begins at the place. */
    RIGHT,
}

/**
 * A picture that a [Pen] can draw. Each pen has its own kind.
 *
 * @property source the whole picture as a data URL.
 * @property width the width in the picture's own pixels.
 * @property height the height in the picture's own pixels.
 */
abstract class PenImage(val source: String, val width: Int, val height: Int)

/**
 * The distance of a text's baseline below the middle of its small letters, as a fraction of the font size. It is the same for all pens,
 * so that their pictures agree.
 */
const val BASELINE: Double = 0.35

/** A growing list of places, x and y alternating, without an allocation for each place. It is reused for the next drawing. */
class Points {
    /** The numbers, in the first [size] entries. */
    var values: DoubleArray = DoubleArray(FIRST)
        private set

    /** The number of used entries in [values]: two for each place. */
    var size: Int = 0
        private set

    /** Adds the place ([x], [y]). */
    fun add(x: Double, y: Double): Points {
        if (size == values.size) values = values.copyOf(size * 2)
        values[size++] = x
        values[size++] = y
        return this
    }

    /** Adds both ends of a line. */
    fun line(fromX: Double, fromY: Double, toX: Double, toY: Double): Points = add(fromX, fromY).add(toX, toY)

    fun clear(): Points {
        size = 0
        return this
    }
}

/** Returns [text], or its beginning and `…` if it is wider than [room]. */
fun Pen.fittedStart(text: String, room: Double, letters: Double, isBold: Boolean = false): String =
    fitted(text, room, letters, isBold) { text.take(it) + "…" }

/** Returns [text], or both its ends with `…` between if it is wider than [room]. Names often differ only at their ends. */
fun Pen.fittedEnds(text: String, room: Double, letters: Double): String = fitted(text, room, letters, isBold = false) { length ->
    text.take(length / 2) + "…" + text.takeLast(length - length / 2)
}

private fun Pen.fitted(text: String, room: Double, letters: Double, isBold: Boolean, cut: (Int) -> String): String {
    if (widthOf(text, letters, isBold) <= room) return text
    var fits = 0
    var tooLong = text.length
    while (tooLong - fits > 1) {
        val length = (fits + tooLong) / 2
        if (widthOf(cut(length), letters, isBold) <= room) fits = length else tooLong = length
    }
    return cut(fits)
}

private const val FIRST = 32
