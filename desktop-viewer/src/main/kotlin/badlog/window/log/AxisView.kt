package badlog.window.log

import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import badlog.core.analysis.Span
import badlog.rules.Finding
import badlog.viewer.choices.range.Viewport
import badlog.viewer.draw.mark.FindingPlace
import badlog.viewer.input.KeyAction
import badlog.viewer.shown.cursor.Cursors
import badlog.viewer.state.Action
import badlog.viewer.state.EndFollowing
import badlog.viewer.state.FindingsState
import badlog.viewer.state.Place
import badlog.viewer.state.PlaceAction
import badlog.viewer.state.StatisticsState
import badlog.viewer.state.Store

/** The person's place in the log, see [Place], which [store] holds, and the current drag. Use it only on the window's thread. */
internal class AxisView(private val store: Store) {
    // Each is read separately, so that moving the cursor redraws only the cursor. Combinations of them for a snapshotFlow
    // need their own equals, as data classes have; otherwise each move of the cursor emits a new value.

    /** The whole place, for actions. Drawings use its parts below, so that they are redrawn only when those change. */
    val place: Place get() = store.state.place

    /** The visible range of x. */
    val viewport: Viewport by derivedStateOf { store.state.place.range }

    /** The cursors, the same in all graphs. */
    val cursors: Cursors by derivedStateOf { store.state.place.cursors }

    /** The x at which values are read; null for none. */
    val cursor: Double? by derivedStateOf { store.state.place.cursors.x }

    /** Whether the cursor stays where it is instead of following the pointer. */
    val isCursorPinned: Boolean by derivedStateOf { store.state.place.cursors.isPinned }

    /** The x of the second cursor, which is compared with the first; null for none. */
    val secondCursor: Double? by derivedStateOf { store.state.place.cursors.second }

    /** The selected range of x, or null. */
    val selection: Span? by derivedStateOf { store.state.place.selection }

    /** The place of the finding that a person went to last; null for none. */
    val visited: FindingPlace<Finding>? by derivedStateOf { store.state.place.visited }

    /** The search in the findings. */
    val findings: FindingsState by derivedStateOf { store.state.findings }

    /** The choices for statistics. */
    val statistics: StatisticsState by derivedStateOf { store.state.statistics }

    /** Whether the person has unfolded or folded the parts of panels, by the parts' keys. */
    val unfolded: Map<String, Boolean> by derivedStateOf { store.state.unfolded }

    /** Whether the person stays at the end of a log that grows. */
    val following: EndFollowing get() = store.state.following

    /** The current drag over a graph, or null. */
    var gesture: PlotGesture? by mutableStateOf(null)

    /** Lets [action] change the state. When another log is opened or the x axis changes, the current drag ends without effect. */
    fun send(action: Action) {
        if (action is PlaceAction.Open || (action is PlaceAction.Grow && action.isOtherAxis)) gesture = null
        store.send(action)
    }

    /** Performs the action of [key]. */
    fun press(key: KeyAction) = send(Action.Press(key))

    /**
     * Cancels the first of these that exists: drag, selection, second cursor, pinned cursor, cursor.
     *
     * @return whether there was one.
     */
    fun cancel(): Boolean {
        val drag = gesture?.drag
        val before = place
        gesture = null
        if (drag == null) send(PlaceAction.Cancel) else drag.undoing?.let(::send)
        return drag != null || place != before
    }
}
