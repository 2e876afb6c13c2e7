package badlog.viewer.draw.curve

import badlog.core.analysis.Span
import kotlin.math.abs

/**
 * A [Curve] ready for drawing: the strokes between its gaps, and dots. The arrays are reused for the next drawing.
 *
 * Every sample has a dot if there are few; otherwise only isolated samples between two gaps have one, because no stroke shows them.
 */
class Strokes {
    /** x and y of all points, alternating; stroke `i` has the numbers from index [startOf] until [endOf]. */
    var points: DoubleArray = DoubleArray(0)
        private set

    /** The number of strokes. A stroke may be a single point. */
    var count: Int = 0
        private set

    /** x and y of all dots, alternating, in the first [dotsSize] entries. */
    var dots: DoubleArray = DoubleArray(0)
        private set

    /** The number of used entries in [dots]: two for each dot. */
    var dotsSize: Int = 0
        private set

    /** Whether the samples are far apart, see [Curve.isSparse]. */
    var isSparse: Boolean = false
        private set

    /**
     * Whether there are so many points that thin lines cover the same area, see [Curve.isDense]. Thicker lines take many times longer.
     */
    var isDense: Boolean = false
        internal set

    /** The smallest visible value, see [Curve.min]. */
    var min: Double = Double.NaN
        private set

    /** The largest visible value, see [Curve.max]. */
    var max: Double = Double.NaN
        private set

    private var ends = IntArray(0)
    private var size = 0

    /** Returns the index in [points] where stroke [index] begins. */
    fun startOf(index: Int): Int = if (index == 0) 0 else ends[index - 1]

    /** Returns the index in [points] where stroke [index] ends. */
    fun endOf(index: Int): Int = ends[index]

    /** Replaces the content by the points of [curve], mapped by the scales [x] and [y]. */
    fun trace(curve: Curve, x: Scale, y: Scale) {
        isSparse = curve.isSparse
        isDense = curve.isDense
        min = curve.min
        max = curve.max
        begin()
        for (i in 0 until curve.size) {
            val value = curve.y[i]
            if (value.isNaN()) {
                lift()
                continue
            }
            add(x.placeOf(curve.x[i]), y.placeOf(value))
            if (if (isSparse) !curve.isCorner(i) else isAlone(curve, i)) dot(points[size - 2], points[size - 1])
        }
        lift()
    }

    /** Removes all strokes and dots. */
    internal fun begin() {
        count = 0
        size = 0
        dotsSize = 0
    }

    /** Continues the stroke to ([x], [y]). */
    internal fun add(x: Double, y: Double) {
        if (size == points.size) points = points.copyOf(maxOf(FIRST_POINTS, size * 2))
        points[size++] = x
        points[size++] = y
    }

    /** Maps the logged y of all strokes by the scale [y], which may be known only after other curves were traced. */
    fun place(y: Scale) {
        for (i in 1 until (if (count == 0) 0 else ends[count - 1]) step 2) points[i] = y.placeOf(points[i])
        for (i in 1 until dotsSize step 2) dots[i] = y.placeOf(dots[i])
    }

    /** Maps all places by the scales [x] and [y]. */
    fun place(x: Scale, y: Scale) {
        for (i in 0 until size step 2) points[i] = x.placeOf(points[i])
        for (i in 0 until dotsSize step 2) dots[i] = x.placeOf(dots[i])
        place(y)
    }

    /** Moves all places by [right] and [down]. */
    fun move(right: Double, down: Double) {
        for (i in 0 until size) points[i] += if (i % 2 == 0) right else down
        for (i in 0 until dotsSize) dots[i] += if (i % 2 == 0) right else down
    }

    /** Ends the stroke; the next point begins another one. */
    internal fun lift() {
        if (size == (if (count == 0) 0 else ends[count - 1])) return
        if (count == ends.size) ends = ends.copyOf(maxOf(FIRST_STROKES, count * 2))
        ends[count++] = size
    }

    /** Adds a dot at ([x], [y]). */
    internal fun dot(x: Double, y: Double) {
        if (dotsSize == dots.size) dots = dots.copyOf(maxOf(FIRST_DOTS, dotsSize * 2))
        dots[dotsSize++] = x
        dots[dotsSize++] = y
    }

    private fun isAlone(curve: Curve, index: Int) =
        (index == 0 || curve.y[index - 1].isNaN()) && (index == curve.size - 1 || curve.y[index + 1].isNaN())
}

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

private const val FIRST_POINTS = 512
private const val FIRST_STROKES = 8
private const val FIRST_DOTS = 32
