package badlog.page.view

import badlog.analysis.Series

/**
 * The one place on the x axis at which every graph tells its values.
 *
 * @param positions the x of each row.
 */
internal class Cursor(positions: DoubleArray) {
    private val times: Series by lazy {
        val finite = positions.filter { it.isFinite() }.toDoubleArray()
        finite.sort()
        Series(finite, finite)
    }
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
        if (times.size == 0) return
        if (!isPlaced) {
            place(times.x[times.nearest(start)])
            return
        }
        var place = x
        repeat(if (count < 0) -count else count) { place = if (count > 0) after(place) else before(place) }
        place(place)
    }

    // Rows that share a time stamp are one step.
    private fun after(place: Double): Double {
        var next = times.firstAtOrAfter(place)
        while (next < times.size && times.x[next] == place) next++
        return if (next < times.size) times.x[next] else times.x.last()
    }

    private fun before(place: Double): Double {
        val next = times.firstAtOrAfter(place)
        return if (next > 0) times.x[next - 1] else times.x.first()
    }
}
