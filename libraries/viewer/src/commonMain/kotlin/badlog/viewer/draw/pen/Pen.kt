package badlog.viewer.draw.pen

import badlog.viewer.draw.curve.Strokes

/**
 * What draws: a browser's canvas, Skia, SVG. Everything that page, window, figures and reports have in common is drawn on one.
 *
 * Places and lengths are in physical pixels, x to the right and y down, from the pen's origin. Colors are `0xAARRGGBB`. Whoever draws works
 * out all places before: a pen measures nothing but texts.
 */
interface Pen {
    /** The number of physical pixels in one CSS pixel or dp. */
    val density: Double

    /** Draws the strokes of [strokes] as lines, [width] wide; 0 for one physical pixel, which is many times faster. A [dash] of 0 is solid. */
    fun lines(strokes: Strokes, color: Int, width: Double, dash: Double = 0.0)

    /** Fills what is between the strokes of [strokes] and the height [baseline]. */
    fun areas(strokes: Strokes, baseline: Double, color: Int)

    /** Draws separate lines, [width] wide: each four numbers of [ends] are x and y of both ends. A [dash] of 0 is solid. */
    fun segments(ends: Points, color: Int, width: Double, dash: Double = 0.0)

    /** Draws the line through all of [places], back to the first one if it [isClosed]. */
    fun chain(places: Points, isClosed: Boolean, color: Int, width: Double)

    /** Fills areas with as many [corners] each, which [places] contains one after the other. */
    fun shapes(places: Points, corners: Int, color: Int)

    /** Fills a circle of [radius] at each of [places]. */
    fun dots(places: Points, radius: Double, color: Int)

    /** Draws a circle, its line [width] wide. */
    fun ring(x: Double, y: Double, radius: Double, color: Int, width: Double)

    /** Fills a rectangle. */
    fun rectangle(left: Double, top: Double, width: Double, height: Double, color: Int)

    /**
     * Writes [text] beside [x], on the side that [side] says, with its small letters around the height [middle].
     *
     * @param letters the font size.
     * @param halo the color of an outline that separates it from what is below; null for none.
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

    /** Shows of what [draw] draws only the part in the rectangle. */
    fun clip(left: Double, top: Double, width: Double, height: Double, draw: () -> Unit)

    /** Draws [draw] with its origin at ([x], [y]). */
    fun moved(x: Double, y: Double, draw: () -> Unit)

    /**
     * Draws what many graphs share: a pen may draw it once and copy it while [key] stays the same.
     *
     * @param name which of the shared drawings this is.
     * @param draw draws it at the origin of the pen that it gets, in the height that it gets; of a higher drawing, the bottom is shown.
     */
    fun layer(name: String, left: Double, top: Double, width: Double, height: Double, key: List<Any?>, draw: (Pen, Double) -> Unit): Unit =
        moved(left, top) { draw(this, height) }
}

/** Where a text is, seen from its place. */
enum class TextSide {
    /** Ends there. */
    LEFT,

    /** Has its middle there. */
    CENTER,

    /** Begins there. */
    RIGHT,
}

/**
 * A picture that a [Pen] can draw. Each pen has its own kind.
 *
 * @property source all of it as a data URL.
 * @property width in its own pixels.
 * @property height in its own pixels.
 */
abstract class PenImage(val source: String, val width: Int, val height: Int)

/**
 * How far the baseline of a text is below the middle of its small letters, as a fraction of the font size: the same for all pens, so that
 * their pictures agree.
 */
const val BASELINE: Double = 0.35
