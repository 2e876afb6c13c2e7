package badlog.window.log

import androidx.compose.runtime.SnapshotMutationPolicy
import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.setValue
import badlog.core.analysis.Span
import badlog.rules.Finding
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.BoardHistory
import badlog.viewer.choices.board.fittedTo
import badlog.viewer.choices.board.titleOf
import badlog.viewer.choices.range.Viewport
import badlog.viewer.draw.mark.FindingPlace
import badlog.viewer.input.KeyAction
import badlog.viewer.session.gesture.PlotDrag
import badlog.viewer.shown.cursor.Cursors
import badlog.viewer.state.AcrossState
import badlog.viewer.state.Action
import badlog.viewer.state.BoardAction
import badlog.viewer.state.EndFollowing
import badlog.viewer.state.FindingsState
import badlog.viewer.state.GraphChange
import badlog.viewer.state.Place
import badlog.viewer.state.PlaceAction
import badlog.viewer.state.Request
import badlog.viewer.state.StatisticsState
import badlog.viewer.state.Store
import badlog.viewer.state.ViewerState

/**
 * The graphs that the window shows, from top to bottom, with their history. Use it only on the window's thread.
 *
 * @param store holds them.
 * @param isDrawn returns whether the open log can draw the line with a name. Graphs without such a line stay on the board, but are not
 * shown.
 */
internal class GraphBoard(private val store: Store, private val isDrawn: (String) -> Boolean = { true }) {
    // Follows only the graphs: nothing here is calculated again while the cursor moves.
    private val kept: ViewerState by derivedStateOf(SameGraphs) { store.state }

    /** All graphs, also those that the open log cannot draw, with their history. */
    val history: BoardHistory get() = kept.board

    /** The graphs that are shown. Composables that draw them are recomposed when they change. */
    val state: Board by derivedStateOf {
        val whole = history.now
        drawn(whole).takeIf { it != whole } ?: whole
    }

    /** All graphs that a person arranged, also those that the open log cannot draw. */
    val arranged: Board by derivedStateOf { kept.arranged }

    /** Whether there is something to undo. */
    val canUndo: Boolean get() = history.canUndo

    /** Whether there is something to redo. */
    val canRedo: Boolean get() = history.canRedo

    /** The graphs that were put on top to show a finding, unless a person has changed them. */
    val evidence: Board by derivedStateOf { kept.evidenceIn(state) }

    /** The graph to scroll to; null if it is visible. */
    var wanted: Int? by mutableStateOf(null)
        private set

    /** The ids of the graphs that are at least half visible; null while no graphs are shown. */
    var inSight: Set<Int>? = null

    /** The id of the graph that the pointer was last over; keys apply to that. */
    var pointed: Int? = null

    /** The graph that a key has just moved. Until the pointer moves, keys go on with it, whatever is below the pointer now. */
    private var moved: Int? = null

    /**
     * The graph that keys apply to: the one just moved, otherwise the one last pointed at, otherwise the first visible one. Null if there
     * are none.
     */
    val current: BoardGraph?
        get() = state.graphs.find { it.id == moved } ?: state.graphs.find { it.id == pointed }
            ?: state.graphs.find { graph -> inSight?.let { graph.id in it } == true }
            ?: state.graphs.firstOrNull()

    /** Returns the title of [graph], which is unique on the board. */
    fun titleOf(graph: BoardGraph): String = state.titleOf(graph)

    /** Returns whether exactly the graphs of [board] that the open log can draw are shown. */
    fun shows(board: Board): Boolean = state.showsSame(drawn(board))

    /** Scrolls to the changed graphs, and to the graph that a key has moved, if they are out of sight. */
    fun follow(change: Request.Graphs) {
        val seen = inSight
        change.moved?.let { moved = it }
        if (seen == null) return
        // Nobody looks for graphs added outside the visible part, so scroll to the first of them. If all are new, that is the top.
        val before = change.before?.graphs?.associateBy { it.id }
        val added = state.graphs.filter { graph ->
            before != null && before[graph.id].let { it == null || it.lines.size < graph.lines.size }
        }
        val first = change.moved ?: added.firstOrNull()?.id?.takeIf { added.size < state.graphs.size }
        if (first != null && first !in seen) goTo(first)
    }

    /** Lets [action] change the graphs. */
    fun send(action: BoardAction) = store.send(action)

    /** Replaces all graphs by [board], as for another log, without a history. */
    fun replace(board: Board) = send(BoardAction.Begin(board))

    /** Replaces all graphs by the drawable ones of [board], unless a person has changed something. New graphs in it show a finding. */
    fun beginWith(board: Board) = send(BoardAction.BeginWithEvidence(drawn(board)))

    /** Undoes the last change. */
    fun undo() = store.send(Action.Press(KeyAction.UNDO))

    /** Redoes the change that [undo] undid. */
    fun redo() = store.send(Action.Press(KeyAction.REDO))

    /** Removes the [current] graph; one that is there to show a finding is kept instead. */
    fun togglePin() {
        val graph = current ?: return
        send(if (isEvidence(graph.id)) BoardAction.Keep(graph.id) else GraphChange.Remove(graph.id))
    }

    /** Records that the pointer was moved. */
    fun pointerMoved() {
        moved = null
    }

    /**
     * Shows the graphs of [board] above all others, replacing the graphs of the previous finding. Graphs that a person has changed since
     * stay.
     */
    fun showEvidence(board: Board) {
        send(BoardAction.ShowEvidence(board))
        evidence.graphs.firstOrNull()?.let { wanted = it.id }
    }

    /** Returns whether graph [id] is there only to show a finding. */
    fun isEvidence(id: Int): Boolean = evidence.graphs.any { it.id == id }

    /** Keeps graph [id], which shows a finding, or all such graphs for null. They then count as arranged by a person. */
    fun keep(id: Int? = null) = send(BoardAction.Keep(id))

    /** Scrolls to graph [id]; null if it is already visible. */
    fun goTo(id: Int?) {
        wanted = id
    }

    private fun drawn(board: Board) = board.fittedTo(isThere = isDrawn).board
}

/** Whether two states have the same graphs, by identity. */
private object SameGraphs : SnapshotMutationPolicy<ViewerState> {
    override fun equivalent(a: ViewerState, b: ViewerState) = a.board === b.board && a.added === b.added
}

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

    /** The choices for statistics across logs. */
    val across: AcrossState by derivedStateOf { store.state.across ?: AcrossState() }

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

/** A [drag] that began over [graph]. If [graph] is null, it began over the axis or the overview. */
internal data class PlotGesture(val graph: Int?, val drag: PlotDrag)
