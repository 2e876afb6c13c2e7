package badlog.plot.curve

import badlog.analysis.Span

/**
 * Where the values of an axis stand on the screen: [from] at [start], and [to] so many pixels, [length], further on.
 *
 * @property farthest how far from 0 a place may be: numbers far out of sight would be too large to draw with.
 */
public class Scale(
    private val from: Double,
    private val to: Double,
    private val length: Double,
    private val start: Double = 0.0,
    private val farthest: Double = Double.POSITIVE_INFINITY,
) {
    /** The place of [value]. */
    public fun placeOf(value: Double): Double {
        val place = start + (value - from) / (to - from) * length
        return if (place > farthest) {
            farthest
        } else if (place < -farthest) {
            -farthest
        } else {
            place
        }
    }

    public companion object {
        /** Leaves values as they are. */
        public val NONE: Scale = Scale(0.0, 1.0, 1.0)

        /** [span] from left to right over [width] pixels, the first of which is [left]. */
        public fun ofX(span: Span, width: Double, left: Double = 0.0): Scale = Scale(span.from, span.to, width, left)

        /** [span] upwards over [height] pixels, the highest of which is [top]. */
        public fun ofY(span: Span, height: Double, top: Double = 0.0): Scale =
            Scale(span.to, span.from, height, top, MAX_DISTANCE * height + top)

        private const val MAX_DISTANCE = 50.0
    }
}
