package badlog.viewer.draw.curve

import badlog.core.analysis.Span
import kotlin.math.abs

/**
 * The mapping from the values of an axis to the screen. [from] is at the pixel [start], and [to] is [length] pixels further.
 *
 * @property farthest the maximum distance of a place from 0, because coordinates far outside the screen would be too large for drawing.
 */
class Scale(
    private val from: Double,
    private val to: Double,
    private val length: Double,
    private val start: Double = 0.0,
    private val farthest: Double = Double.POSITIVE_INFINITY,
) {
    /** The difference between the values of two adjacent pixels. */
    internal val unitsPerPixel: Double get() = abs((to - from) / length)

    /** Returns the pixel of [value]. */
    fun placeOf(value: Double): Double {
        val place = start + (value - from) / (to - from) * length
        return if (place > farthest) {
            farthest
        } else if (place < -farthest) {
            -farthest
        } else {
            place
        }
    }

    companion object {
        /** The scale that leaves values as they are. */
        val NONE: Scale = Scale(0.0, 1.0, 1.0)

        /** Returns the scale of [span] from left to right over [width] pixels, starting at [left]. */
        fun ofX(span: Span, width: Double, left: Double = 0.0): Scale = Scale(span.from, span.to, width, left)

        /** Returns the scale of [span] upwards over [height] pixels; [top] is the highest pixel. */
        fun ofY(span: Span, height: Double, top: Double = 0.0): Scale = Scale(span.to, span.from, height, top, MAX_DISTANCE * height + top)

        private const val MAX_DISTANCE = 50.0
    }
}
