package badlog.page.view

import badlog.core.analysis.Span
import badlog.viewer.choices.range.Viewport
import badlog.viewer.shown.cursor.CursorSteps
import badlog.viewer.shown.cursor.Cursors
import badlog.viewer.state.Place

/**
 * The reader's place in the log. Its parts tell those who listen to them alone of their changes: moving a cursor redraws no graph.
 *
 * @param clocks every x at which there is a sample.
 */
internal class PagePlace(viewport: Viewport, clocks: List<DoubleArray>) {
    /** The current place. */
    var now: Place = Place(viewport)
        private set

    /** The samples that keys step to. */
    val samples: CursorSteps = CursorSteps(clocks)

    /** The part of x that every graph shows. */
    val range: VisibleRange = VisibleRange(this)

    /** The places at which every graph shows its values. */
    val cursor: Cursor = Cursor(this)

    /** Goes to the result of [step]. */
    fun change(step: Place.() -> Place) {
        val before = now
        now = before.step()
        if (now.range.visible != before.range.visible) range.announce()
        // It may be another finding at the same place.
        if (now.cursors != before.cursors || now.visited !== before.visited) cursor.announce()
    }
}

/** The part of the x axis that every graph of the page shows; calls its listeners after each change. */
internal class VisibleRange(private val place: PagePlace) {
    private val listeners = ArrayList<() -> Unit>()

    /** The current and previous visible ranges. */
    val viewport: Viewport get() = place.now.range
    val full: Span get() = viewport.full
    val now: Span get() = viewport.visible
    val isZoomed: Boolean get() = viewport.isZoomed
    val canGoBack: Boolean get() = viewport.canGoBack

    /** Calls [listener] after each change. */
    fun onChange(listener: () -> Unit) {
        listeners += listener
    }

    /** Changes the visible range by [step]. */
    fun change(step: Viewport.() -> Viewport) = place.change { copy(range = range.step()) }

    /** Calls the listeners. */
    fun announce() {
        for (listener in listeners) listener()
    }
}

/** The places on the x axis at which every graph shows its values; calls its listeners after each change. */
internal class Cursor(private val place: PagePlace) {
    private val listeners = ArrayList<() -> Unit>()

    /** Their places. */
    val now: Cursors get() = place.now.cursors

    /** The x at which values are read; NaN for none. */
    val x: Double get() = now.x ?: Double.NaN

    val isPlaced: Boolean get() = now.x != null

    /** Calls [listener] after each change. */
    fun onChange(listener: () -> Unit) {
        listeners += listener
    }

    /** Changes their places by [step]. */
    fun change(step: Cursors.() -> Cursors) = place.change { copy(cursors = cursors.step()) }

    /** Calls the listeners, so that the values at the cursors are read again. */
    fun announce() {
        for (listener in listeners) listener()
    }
}
