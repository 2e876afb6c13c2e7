package badlog.viewer.view

import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import badlog.analysis.Span
import badlog.plot.cursor.Cursors
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

    /** The cursors, the same in all graphs. */
    val cursors: Cursors by derivedStateOf { state.cursors }

    /** Where on x values are read; null for nowhere. */
    val cursor: Double? by derivedStateOf { state.cursors.x }

    /** Whether the cursor stays where it is rather than going with the pointer. */
    val isCursorPinned: Boolean by derivedStateOf { state.cursors.isPinned }

    /** Where the cursor stands that is compared with the first; null for nowhere. */
    val secondCursor: Double? by derivedStateOf { state.cursors.second }

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

    /** Puts the cursors where [step] leads to. */
    fun changeCursors(step: Cursors.() -> Cursors) {
        state = state.copy(cursors = state.cursors.step())
    }

    /** Places the cursor at [x], as it is: pinned, or where the pointer could be. */
    fun placeCursor(x: Double) = changeCursors { if (isPinned) pinnedAt(x) else hovering(x) }

    /** Pins the cursor at [x], and shows that. */
    fun goTo(x: Double) {
        state = state.copy(cursors = state.cursors.pinnedAt(x), viewport = state.viewport.revealing(x))
    }

    /** Pins the cursor at [x], and shows what is around [span]. */
    fun goTo(x: Double, span: Span) {
        state = state.copy(cursors = state.cursors.pinnedAt(x), viewport = state.viewport.around(span.from, span.to).revealing(x))
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
     * Cancels what a person is in the middle of: a drag, else the selection, else the second cursor, else the pinned one, else the cursor.
     *
     * @return whether there was anything.
     */
    fun cancel(): Boolean {
        val before = state
        val gesture = before.gesture
        state = when {
            gesture != null -> before.copy(gesture = null, viewport = gesture.before)
            before.selection != null -> before.copy(selection = null)
            else -> before.copy(cursors = before.cursors.cancelled())
        }
        return state != before
    }

    private data class AxisState(
        val viewport: Viewport = Viewport(Span(0.0, 1.0)),
        val cursors: Cursors = Cursors(),
        val selection: Span? = null,
        val gesture: PlotGesture? = null,
    )
}
