package badlog.viewer.draw.path

import badlog.core.analysis.Span
import kotlin.math.abs

/** Returns the time of the nearest place in [pyramid], as [XyPlot.timeAt] describes; NaN if there is none. */
internal fun timeOfNearest(
    pyramid: TrailPyramid,
    x: Double,
    y: Double,
    pixelX: Double,
    pixelY: Double,
    reach: Double,
    visible: Span,
    before: Double?,
): Double {
    val trail = pyramid.trail
    val start = trail.startOf(visible)
    val end = trail.endOf(visible)
    fun square(atX: Double, atY: Double): Double {
        val right = (atX - x) / pixelX
        val up = (atY - y) / pixelY
        return right * right + up * up
    }

    // The distance of a sample without a place is NaN, so it is not near.
    fun distance(i: Int) = square(trail.x[i], trail.y[i])
    fun distance(boxes: DoubleArray, at: Int) = square(
        maxOf(boxes[at], minOf(x, boxes[at + 1])),
        maxOf(boxes[at + 2], minOf(y, boxes[at + 3])),
    )

    var least = reach * reach
    var nearest = Double.NaN
    // The first pass finds the least distance. The second one finds the time nearest to [before] among places with about that distance.
    for (more in if (before == null) FIRST else BOTH) {
        pyramid.visit(start, end, { boxes, at, _ -> distance(boxes, at) > least + more }, {}) { i ->
            val here = distance(i)
            val time = trail.times[i]
            if (before != null && more > 0) {
                if (here <= least + more && abs(time - before) < abs(nearest - before)) nearest = time
            } else if (here < least || (here == least && nearest.isNaN())) {
                least = here
                nearest = time
            }
        }
    }
    return nearest
}

private val FIRST = doubleArrayOf(0.0)

/** The tolerance of both passes, in square pixels. Places with squared distances that differ by at most that count as the same. */
private val BOTH = doubleArrayOf(0.0, 9.0)
