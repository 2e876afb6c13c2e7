package badlog.page.view

import badlog.analysis.Series
import kotlin.math.abs

/**
 * The one place on the x axis at which every graph tells its values.
 *
 * @param clocks every x at which there is a sample; of several arrays, each ascends.
 */
internal class Cursor(clocks: List<DoubleArray>) {
    private val times: List<Series> by lazy { clocks.map(::seriesOf).filter { it.size > 0 } }
    private val listeners = ArrayList<() -> Unit>()

    /** Where it stands; NaN when it is nowhere. */
    var x: Double = Double.NaN
        private set

    val isPlaced: Boolean get() = !x.isNaN()

    /** Calls [listener] after each change. */
    fun onChange(listener: () -> Unit) {
        listeners += listener
    }

    /** Puts it at [position], or nowhere. */
    fun place(position: Double) {
        if (position == x || (position.isNaN() && x.isNaN())) return
        x = position
        for (listener in listeners) listener()
    }

    /** Moves it by [count] samples, back when negative; from [start] when it is nowhere. */
    fun step(count: Int, start: Double) {
        if (times.isEmpty()) return
        if (!isPlaced) {
            place(times.map { it.x[it.nearest(start)] }.minBy { abs(it - start) })
            return
        }
        var place = x
        repeat(if (count < 0) -count else count) { place = if (count > 0) after(place) else before(place) }
        place(place)
    }

    // Rows that share a time stamp are one step.
    private fun after(place: Double): Double = times.minOf { it.x.getOrElse(it.firstAfter(place)) { Double.POSITIVE_INFINITY } }
        .let { if (it.isFinite()) it else times.maxOf { clock -> clock.x.last() } }

    private fun before(place: Double): Double = times.maxOf { it.x.getOrElse(it.firstAtOrAfter(place) - 1) { Double.NEGATIVE_INFINITY } }
        .let { if (it.isFinite()) it else times.minOf { clock -> clock.x.first() } }
}

private fun seriesOf(positions: DoubleArray): Series {
    val whole = Series(positions, positions)
    if (whole.isOrdered && positions.all { it.isFinite() }) return whole
    val finite = positions.filter { it.isFinite() }.toDoubleArray()
    finite.sort()
    return Series(finite, finite)
}
