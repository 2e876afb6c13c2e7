package badlog.viewer.view

import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import badlog.analysis.Span
import badlog.plot.range.Viewport

/**
 * What all graphs share of x: the part of it that is visible, the cursor, the selection, and what is being dragged. To be used on
 * the window's thread only.
 */
internal class AxisView {
    private var state by mutableStateOf(AxisState())

    // Each read by itself, so that a cursor that moves draws nothing again but the cursor. What is put together of them for a
    // snapshotFlow needs an equals of its own, as data classes have: else each move of the cursor flows on as news.

    /** Which part of x is visible. */
    val viewport: Viewport by derivedStateOf { state.viewport }

    /** Where on x the cursor stands, the same in all graphs; null for nowhere. */
    val cursor: Double? by derivedStateOf { state.cursor }

    /** Whether the cursor stays where it is rather than going with the pointer. */
    val isCursorPinned: Boolean by derivedStateOf { state.isCursorPinned }

    /** The part of x that a person has selected, or null. */
    val selection: Span? by derivedStateOf { state.selection }

    /** What is being dragged over a graph now, or null. */
    val gesture: PlotGesture? by derivedStateOf { state.gesture }

    /** Shows all of [full], as of another recording: without a cursor and a selection. */
    fun show(full: Span) {
        state = AxisState(Viewport(full))
    }

    /** Replaces the visible range by what [transition] makes of it. */
    fun change(transition: Viewport.() -> Viewport) {
        state = state.copy(viewport = state.viewport.transition())
    }

    /** Places the cursor at [x], null for nowhere. */
    fun placeCursor(x: Double?, isPinned: Boolean = state.isCursorPinned) {
        state = state.copy(cursor = x, isCursorPinned = isPinned)
    }

    /** Lets the cursor go with the pointer again. */
    fun unpinCursor() {
        state = state.copy(isCursorPinned = false)
    }

    /** Pins the cursor at [x], and shows that. */
    fun goTo(x: Double) {
        state = state.copy(cursor = x, isCursorPinned = true, viewport = state.viewport.revealing(x))
    }

    /** Pins the cursor at [x], and shows what is around [span]. */
    fun goTo(x: Double, span: Span) {
        state = state.copy(cursor = x, isCursorPinned = true, viewport = state.viewport.around(span.from, span.to).revealing(x))
    }

    /** Selects [span]; null for nothing. */
    fun select(span: Span?) {
        state = state.copy(selection = span)
    }

    /** Is being dragged by [gesture] from now on; null when that has ended. */
    fun drag(gesture: PlotGesture?) {
        state = state.copy(gesture = gesture)
    }

    /**
     * Cancels what a person is in the middle of: a drag, else the selection, else the pinned cursor, else the cursor.
     *
     * @return whether there was anything.
     */
    fun cancel(): Boolean {
        val before = state
        val gesture = before.gesture
        state = when {
            gesture != null -> before.copy(gesture = null, viewport = gesture.before)
            before.selection != null -> before.copy(selection = null)
            before.isCursorPinned -> before.copy(isCursorPinned = false)
            else -> before.copy(cursor = null)
        }
        return state != before
    }

    private data class AxisState(
        val viewport: Viewport = Viewport(Span(0.0, 1.0)),
        val cursor: Double? = null,
        val isCursorPinned: Boolean = false,
        val selection: Span? = null,
        val gesture: PlotGesture? = null,
    )
}
