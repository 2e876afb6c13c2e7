package badlog.viewer.draw.plot

import badlog.core.analysis.Span
import badlog.viewer.choices.board.Plane
import badlog.viewer.draw.curve.Scale
import kotlin.math.round

/**
 * The frame of a plot, in physical pixels, and the part of x that it shows.
 *
 * @property shown the part of x.
 */
class PlotFrame(val left: Double, val top: Double, val width: Double, val height: Double, val shown: Span) {
    /** The scale of x over the frame's width. */
    val x: Scale = Scale.ofX(shown, width, left)
    val right: Double get() = left + width
    val bottom: Double get() = top + height

    /** Returns the same frame with another part of x. */
    fun showing(x: Span): PlotFrame = PlotFrame(left, top, width, height, x)

    /** Returns the part of the frame from [from] to [to], fractions of its height. */
    fun part(from: Double, to: Double): PlotFrame = PlotFrame(left, top + from * height, width, (to - from) * height, shown)

    /** Returns the scale on which [shown] fills the frame's height. */
    fun scaleOf(shown: Span): Scale = Scale.ofY(shown, height, top)

    /** Returns the height of 0 on [y], or of the nearest edge: filled areas end there. */
    fun baselineOf(y: Scale): Double = y.placeOf(0.0).coerceIn(top, bottom)
}

/** The margins of all plots, in CSS pixels: the same x is at the same place in all of them. The page's style sheet also has them. */
object PlotMargins {
    /** The left margin, for the numbers of y and the names of lanes. */
    const val LEFT: Int = 62

    /** The right margin. */
    const val RIGHT: Int = 14

    /** The margin above the plot, in CSS pixels. */
    const val TOP: Int = 6

    /** The margin below, for the numbers of x. */
    const val BOTTOM: Int = 26

    /** The margins above and below together. */
    const val HEIGHT: Int = TOP + BOTTOM

    /** Returns the frame of a plot of [width] by [height] CSS pixels that shows [x]. A CSS pixel is [density] physical pixels. */
    fun frameOf(width: Int, height: Int, x: Span, density: Double): PlotFrame {
        val left = round(LEFT * density)
        val top = round(TOP * density)
        val right = round((width - RIGHT) * density)
        val bottom = round((height - BOTTOM) * density)
        return PlotFrame(left, top, maxOf(1.0, right - left), bottom - top, x)
    }

    /**
     * Returns the height of a plot with all of [plane] in its frame. The scale is the same for x and y. The plot is [width] CSS pixels
     * wide.
     */
    fun heightOf(plane: Plane, width: Int): Int = ((width - LEFT - RIGHT) * plane.y.width / plane.x.width).toInt() + HEIGHT
}
