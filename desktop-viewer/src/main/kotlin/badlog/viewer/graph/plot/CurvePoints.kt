package badlog.viewer.graph.plot

import badlog.analysis.Span
import badlog.plot.curve.Curve

/**
 * The points of a curve, x in pixels already, y still as it was logged: the scale of y is known only when all lines of a graph are.
 *
 * @property x where each point stands, in pixels from the left.
 * @property y its value; NaN where the line is broken.
 * @property isCorner whether it is no sample, but where a value ends that has held until there.
 * @property min the smallest value to be seen; NaN without one.
 * @property max the largest.
 */
internal class CurvePoints(
    val x: FloatArray,
    val y: DoubleArray,
    private val isCorner: BooleanArray,
    val min: Double,
    val max: Double,
    val isDense: Boolean,
    val isSparse: Boolean,
) {
    /** x and y in pixels in turn, one array for each part between gaps; [yPixel] tells where a value stands. */
    inline fun polylines(yPixel: (Double) -> Float): List<FloatArray> {
        val parts = ArrayList<FloatArray>()
        val buffer = FloatArray(2 * x.size)
        var count = 0
        for (i in 0..x.size) {
            if (i < x.size && !y[i].isNaN()) {
                buffer[count++] = x[i]
                buffer[count++] = yPixel(y[i])
            } else if (count > 0) {
                parts += buffer.copyOf(count)
                count = 0
            }
        }
        return parts
    }

    /** The samples that deserve a dot, x and y in pixels in turn: each of few, and what stands alone between two gaps. */
    inline fun dots(yPixel: (Double) -> Float): FloatArray {
        val dotted = x.indices.filter { !y[it].isNaN() && if (isSparse) !isCorner(it) else isAlone(it) }
        val dots = FloatArray(2 * dotted.size)
        dotted.forEachIndexed { i, point ->
            dots[2 * i] = x[point]
            dots[2 * i + 1] = yPixel(y[point])
        }
        return dots
    }

    fun isCorner(index: Int): Boolean = isCorner[index]

    fun isAlone(index: Int): Boolean = (index == 0 || y[index - 1].isNaN()) && (index == y.size - 1 || y[index + 1].isNaN())

    companion object {
        /** A copy of what [curve] has found for [visible], which [width] pixels show. */
        fun of(curve: Curve, visible: Span, width: Int): CurvePoints {
            val scale = width / visible.width
            return CurvePoints(
                x = FloatArray(curve.size) { ((curve.x[it] - visible.from) * scale).toFloat() },
                y = curve.y.copyOf(curve.size),
                isCorner = BooleanArray(curve.size, curve::isCorner),
                min = curve.min,
                max = curve.max,
                isDense = curve.isDense,
                isSparse = curve.isSparse,
            )
        }
    }
}
