package badlog.viewer.shown.cursor

import badlog.core.analysis.Series
import kotlin.math.abs

/**
 * The places on x that the cursor steps to: places with a sample, each once.
 *
 * @param clocks every x with a sample, see [badlog.core.analysis.XAxis.clocks]; may have gaps, and may go backwards. Evaluated at the
 *   first step.
 */
class CursorSteps(clocks: List<DoubleArray>) {
    private val places: List<Series> by lazy { clocks.map(::ascending).filter { it.size > 0 } }

    /** Returns the place nearest to [x]; NaN if there are no samples. */
    fun nearest(x: Double): Double {
        var nearest = Double.NaN
        for (clock in places) {
            val place = clock.x[clock.nearest(x)]
            if (nearest.isNaN() || abs(place - x) < abs(nearest - x)) nearest = place
        }
        return nearest
    }

    /**
     * Returns the place [count] steps after [x], or before it if negative. The steps end at the last and the first place. NaN if there
     * are no samples.
     */
    fun from(x: Double, count: Int): Double {
        if (places.isEmpty()) return Double.NaN
        var place = x
        repeat(abs(count)) { place = if (count > 0) after(place) else before(place) }
        return place
    }

    private fun after(x: Double): Double {
        var next = Double.POSITIVE_INFINITY
        for (clock in places) {
            val index = clock.firstAfter(x)
            if (index < clock.size) next = minOf(next, clock.x[index])
        }
        return if (next.isFinite()) next else places.maxOf { it.x.last() }
    }

    private fun before(x: Double): Double {
        var next = Double.NEGATIVE_INFINITY
        for (clock in places) {
            val index = clock.firstAtOrAfter(x) - 1
            if (index >= 0) next = maxOf(next, clock.x[index])
        }
        return if (next.isFinite()) next else places.minOf { it.x.first() }
    }
}

private fun ascending(positions: DoubleArray): Series {
    val whole = Series(positions, positions)
    var isWhole = whole.isOrdered
    for (x in positions) if (!x.isFinite()) isWhole = false
    if (isWhole) return whole
    var count = 0
    val finite = DoubleArray(positions.size)
    for (x in positions) if (x.isFinite()) finite[count++] = x
    val sorted = finite.copyOf(count)
    sorted.sort()
    return Series(sorted, sorted)
}
