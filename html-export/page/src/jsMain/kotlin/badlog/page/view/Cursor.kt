package badlog.page.view

import badlog.viewer.shown.cursor.CursorSteps
import badlog.viewer.shown.cursor.Cursors

/**
 * The places on the x axis at which every graph shows its values.
 *
 * @param clocks every x at which there is a sample.
 */
internal class Cursor(clocks: List<DoubleArray>) {
    private val steps = CursorSteps(clocks)
    private val listeners = ArrayList<() -> Unit>()

    /** Their places. */
    var now: Cursors = Cursors()
        private set

    /** The x at which values are read; NaN for none. */
    val x: Double get() = now.x ?: Double.NaN

    val isPlaced: Boolean get() = now.x != null

    /** Calls [listener] after each change. */
    fun onChange(listener: () -> Unit) {
        listeners += listener
    }

    /** Changes their places by [step]. */
    fun change(step: Cursors.() -> Cursors) {
        val before = now
        now = before.step()
        if (now != before) announce()
    }

    /** Calls the listeners, so that the values at the cursors are read again. */
    fun announce() {
        for (listener in listeners) listener()
    }

    /** Moves the cursor that keys move by [count] samples, back if negative; if it has no place, to the sample nearest to [start]. */
    fun step(count: Int, start: Double) = change { moved(steps.nearest(start)) { steps.from(it, count) } }
}
