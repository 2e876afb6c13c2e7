package badlog.page.view

import badlog.plot.cursor.CursorSteps

/**
 * The one place on the x axis at which every graph shows its values.
 *
 * @param clocks every x at which there is a sample.
 */
internal class Cursor(clocks: List<DoubleArray>) {
    private val steps = CursorSteps(clocks)
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

    /** Moves it by [count] samples, back when negative; to the one nearest to [start] when it is nowhere. */
    fun step(count: Int, start: Double) = place(if (isPlaced) steps.from(x, count) else steps.nearest(start))
}
