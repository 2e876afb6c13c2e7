package badlog.window.log

import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import badlog.core.analysis.Span
import badlog.rules.Finding
import badlog.viewer.choices.range.Viewport
import badlog.viewer.draw.mark.FindingPlace
import badlog.viewer.shown.cursor.Cursors
import badlog.viewer.state.Place

/**
 * The person's place in the log, see [Place], and the current drag. Use it only on the window's thread.
 */
internal class AxisView {
    private var state by mutableStateOf(AxisState())

    // Each is read separately, so that moving the cursor redraws only the cursor. Combinations of them for a snapshotFlow
    // need their own equals, as data classes have; otherwise each move of the cursor emits a new value.

    /** All of it: for what happens, not for what is drawn, see above. */
    val place: Place get() = state.place

    /** The visible range of x. */
    val viewport: Viewport by derivedStateOf { state.place.range }

    /** The cursors, the same in all graphs. */
    val cursors: Cursors by derivedStateOf { state.place.cursors }

    /** The x at which values are read; null for none. */
    val cursor: Double? by derivedStateOf { state.place.cursors.x }

    /** Whether the cursor stays where it is instead of following the pointer. */
    val isCursorPinned: Boolean by derivedStateOf { state.place.cursors.isPinned }

    /** The x of the second cursor, which is compared with the first; null for none. */
    val secondCursor: Double? by derivedStateOf { state.place.cursors.second }

    /** The selected range of x, or null. */
    val selection: Span? by derivedStateOf { state.place.selection }

    /** The place of the finding that a person went to last; null for none. */
    val visited: FindingPlace<Finding>? by derivedStateOf { state.place.visited }

    /** The current drag over a graph, or null. */
    val gesture: PlotGesture? by derivedStateOf { state.gesture }

    /** Shows all of [full], as for another recording: without cursor, selection and finding. */
    fun show(full: Span) {
        state = AxisState(Place(Viewport(full)))
    }

    /** Goes to the result of [step]. */
    fun go(step: Place.() -> Place) {
        state = state.copy(place = state.place.step())
    }

    /** Replaces the visible range by the result of [transition]. */
    fun change(transition: Viewport.() -> Viewport) = go { copy(range = range.transition()) }

    /** Replaces the cursors by the result of [step]. */
    fun changeCursors(step: Cursors.() -> Cursors) = go { copy(cursors = cursors.step()) }

    /** Places the cursor at [x]; a pinned cursor stays pinned. */
    fun placeCursor(x: Double) = changeCursors { if (isPinned) pinnedAt(x) else hovering(x) }

    /** Selects [span]; null selects nothing. */
    fun select(span: Span?) = go { copy(selection = span) }

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
        val drag = before.gesture?.drag
        state = if (drag == null) before.copy(place = before.place.cancelled()) else AxisState(drag.cancelledAt(before.place))
        return state != before
    }

    private data class AxisState(val place: Place = Place(Viewport(Span(0.0, 1.0))), val gesture: PlotGesture? = null)
}
