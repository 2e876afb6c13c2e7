package badlog.page.view

import badlog.plot.cursor.CursorSteps
import badlog.plot.cursor.Cursors

/**
 * The places on the x axis at which every graph shows its values.
 *
 * @param clocks every x at which there is a sample.
 */
internal class Cursor(clocks: List<DoubleArray>) {
    private val steps = CursorSteps(clocks)
    private val listeners = ArrayList<() -> Unit>()

    /** Where they stand. */
    var now: Cursors = Cursors()
        private set

    /** Where values are read; NaN for nowhere. */
    val x: Double get() = now.x ?: Double.NaN

    val isPlaced: Boolean get() = now.x != null

    /** Calls [listener] after each change. */
    fun onChange(listener: () -> Unit) {
        listeners += listener
    }

    /** Puts them where [step] leads to. */
    fun change(step: Cursors.() -> Cursors) {
        val before = now
        now = before.step()
        if (now != before) announce()
    }

    /** Lets what stands at the cursors be read again. */
    fun announce() {
        for (listener in listeners) listener()
    }

    /** Moves the one that keys move by [count] samples, back when negative; to the one nearest to [start] when it is nowhere. */
    fun step(count: Int, start: Double) = change { moved(steps.nearest(start)) { steps.from(it, count) } }
}
