package badlog.window.log

import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import badlog.core.analysis.Span
import badlog.viewer.choices.range.Viewport
import badlog.viewer.shown.cursor.Cursors

/**
 * The state of x that all graphs share: the visible range, the cursors, the selection, and the current drag. Use it only on the
 * window's thread.
 */
internal class AxisView {
    private var state by mutableStateOf(AxisState())

    // Each is read separately, so that moving the cursor redraws only the cursor. Combinations of them for a snapshotFlow
    // need their own equals, as data classes have; otherwise each move of the cursor emits a new value.

    /** The visible range of x. */
    val viewport: Viewport by derivedStateOf { state.viewport }

    /** The cursors, the same in all graphs. */
    val cursors: Cursors by derivedStateOf { state.cursors }

    /** The x at which values are read; null for none. */
    val cursor: Double? by derivedStateOf { state.cursors.x }

    /** Whether the cursor stays where it is instead of following the pointer. */
    val isCursorPinned: Boolean by derivedStateOf { state.cursors.isPinned }

    /** The x of the second cursor, which is compared with the first; null for none. */
    val secondCursor: Double? by derivedStateOf { state.cursors.second }

    /** The selected range of x, or null. */
    val selection: Span? by derivedStateOf { state.selection }

    /** The current drag over a graph, or null. */
    val gesture: PlotGesture? by derivedStateOf { state.gesture }

    /** Shows all of [full], as for another recording: without cursor and selection. */
    fun show(full: Span) {
        state = AxisState(Viewport(full))
    }

    /** Replaces the visible range by the result of [transition]. */
    fun change(transition: Viewport.() -> Viewport) {
        state = state.copy(viewport = state.viewport.transition())
    }

    /** Replaces the cursors by the result of [step]. */
    fun changeCursors(step: Cursors.() -> Cursors) {
        state = state.copy(cursors = state.cursors.step())
    }

    /** Places the cursor at [x]; a pinned cursor stays pinned. */
    fun placeCursor(x: Double) = changeCursors { if (isPinned) pinnedAt(x) else hovering(x) }

    /** Pins the cursor at [x] and shows it. */
    fun goTo(x: Double) {
        state = state.copy(cursors = state.cursors.pinnedAt(x), viewport = state.viewport.revealing(x))
    }

    /** Pins the cursor at [x] and shows the surroundings of [span]. */
    fun goTo(x: Double, span: Span) {
        state = state.copy(cursors = state.cursors.pinnedAt(x), viewport = state.viewport.around(span.from, span.to).revealing(x))
    }

    /** Selects [span]; null selects nothing. */
    fun select(span: Span?) {
        state = state.copy(selection = span)
    }

    /** Sets the current drag to [gesture]; null when it has ended. */
    fun drag(gesture: PlotGesture?) {
        state = state.copy(gesture = gesture)
    }

    /**
     * Cancels the first of these that exists: drag, selection, second cursor, pinned cursor, cursor.
     *
     * @return whether there was one.
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
