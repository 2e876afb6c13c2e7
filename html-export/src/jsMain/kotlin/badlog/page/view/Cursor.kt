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
        var index = times.nearest(x)
        // Rows that share a time stamp are one step.
        repeat(if (count < 0) -count else count) { index = if (count > 0) after(index) else before(index) }
        place(times.x[index])
    }

    private fun after(index: Int): Int {
        var next = index
        while (next < times.size - 1 && times.x[next] == times.x[index]) next++
        return next
    }

    private fun before(index: Int): Int {
        var next = index
        while (next > 0 && times.x[next] == times.x[index]) next--
        return next
    }
}
