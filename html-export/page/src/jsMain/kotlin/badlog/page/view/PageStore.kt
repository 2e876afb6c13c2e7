package badlog.page.view

import badlog.core.analysis.LogView
import badlog.core.analysis.Span
import badlog.viewer.choices.board.BoardHistory
import badlog.viewer.choices.range.Viewport
import badlog.viewer.shown.cursor.Cursors
import badlog.viewer.state.Action
import badlog.viewer.state.Place
import badlog.viewer.state.Request
import badlog.viewer.state.Shown
import badlog.viewer.state.StateCell
import badlog.viewer.state.Store
import badlog.viewer.state.ViewerState

/**
 * The state of the log that the page shows, at first [start]. Each part of the page listens only for the part of the state that it draws,
 * so that moving a cursor redraws no graph.
 *
 * @param shown the content of the log.
 * @param perform carries out requests that only the page can fulfill.
 */
internal class PageStore(start: ViewerState, shown: Shown, perform: (Request) -> Unit) {
    private val listeners = ArrayList<(ViewerState) -> Unit>()

    private val store = Store(
        object : StateCell {
            override var state: ViewerState = start
                set(value) {
                    val before = field
                    field = value
                    // A listener may add others.
                    for (i in 0 until listeners.size) listeners[i](before)
                }
        },
        shown,
        perform,
    )

    /** The current state. */
    val state: ViewerState get() = store.state

    /** The reader's place. */
    val place: Place get() = state.place

    /** The part of x that every graph shows. */
    val range: VisibleRange = VisibleRange(this)

    /** The places at which every graph shows its values. */
    val cursor: Cursor = Cursor(this)

    /** Applies [action] to the state. */
    fun send(action: Action): Unit = store.send(action)

    /** Calls [listener] with the state before, after each change. */
    fun onChange(listener: (before: ViewerState) -> Unit) {
        listeners += listener
    }
}

/** Returns the state in which [view] is shown first: all of it is visible, without graphs. */
internal fun startOf(view: LogView): ViewerState {
    // Other tabs must not give a graph of theirs the same id.
    val board = BoardHistory { (js("Math.random()").unsafeCast<Double>() * Int.MAX_VALUE).toInt() }
    return ViewerState(Place(Viewport.of(view.xAxis.range)), board)
}

/** The part of the x axis that every graph of the page shows. */
internal class VisibleRange(private val store: PageStore) {
    private val viewport: Viewport get() = store.place.range

    /** All of the log's x axis, in its unit. */
    val full: Span get() = viewport.full

    /** The visible part, in the unit of the x axis. */
    val now: Span get() = viewport.visible

    /** Whether a part of the log is not visible. */
    val isZoomed: Boolean get() = viewport.isZoomed
    val canGoBack: Boolean get() = viewport.canGoBack

    /** Calls [listener] after each change. */
    fun onChange(listener: () -> Unit) = store.onChange { if (it.place.range.visible != now) listener() }
}

/** The places on the x axis at which every graph shows its values. */
internal class Cursor(private val store: PageStore) {
    /** The places of the cursors. */
    val now: Cursors get() = store.place.cursors

    /** The x at which values are read; NaN if there is none. */
    val x: Double get() = now.x ?: Double.NaN

    /** Whether there is a cursor, pinned or under the pointer. */
    val isPlaced: Boolean get() = now.x != null

    /** Calls [listener] after each change, so that the values there are read again. */
    fun onChange(listener: () -> Unit) = store.onChange {
        // It may be another finding at the same place.
        if (it.place.cursors != now || it.place.visited !== store.place.visited) listener()
    }
}
