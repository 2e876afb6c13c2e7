package badlog.viewer.state

import badlog.core.analysis.Span
import badlog.rules.Finding
import badlog.viewer.choices.range.Viewport
import badlog.viewer.draw.mark.FindingPlace
import badlog.viewer.shown.cursor.Cursors

/**
 * A person's place in a log. Links contain the visible range, the cursors and the finding, not the selection. Undo does not change it, but
 * the range has a history of its own. Immutable; each transition returns a new one.
 *
 * @property range the visible range of x, with the ranges before it.
 * @property cursors the places at which values are read.
 * @property selection the selected range of x; null for none.
 * @property visited the place of the finding that a person went to last; null for none.
 * @property wanted the finding to select, at its beginning, as soon as it is known; null for none.
 */
data class Place(
    val range: Viewport,
    val cursors: Cursors = Cursors(),
    val selection: Span? = null,
    val visited: FindingPlace<Finding>? = null,
    val wanted: WantedFinding? = null,
) {
    /**
     * The place of a note that a person begins with a key. It is at the pinned cursor if that is visible, otherwise in the middle of the
     * visible range. The pointer does not matter.
     */
    val ofNote: Double get() = cursors.pinned?.takeIf { it in range.visible } ?: range.visible.run { (from + to) / 2 }

    /** Pins the cursor at [x], or at the nearer end of the log if [x] is outside it, and shows it. Nothing changes if x is not finite. */
    internal fun at(x: Double): Place {
        if (!x.isFinite()) return this
        val place = x.coerceIn(range.full.from, range.full.to)
        return copy(range = range.revealing(place), cursors = cursors.pinnedAt(place))
    }

    /** Pins the cursor at [x], and shows the surroundings of [span]. Nothing changes if x is not finite. */
    internal fun at(x: Double, span: Span): Place = if (x.isFinite()) copy(range = range.around(span.from, span.to)).at(x) else this

    /** Goes to [place], the place of a finding. A finding about the whole log changes neither range nor cursor. */
    internal fun visiting(place: FindingPlace<Finding>): Place = copy(visited = place, wanted = null).at(place.span.from, place.span)

    /** Pins the cursor at the end of the log, and moves the visible range there, as wide as it is. Going back returns from it. */
    internal fun atEnd(): Place = copy(range = range.remembered()).movedToEnd()

    /** Does the same as one of many steps of following a growing log; going back skips it. */
    internal fun movedToEnd(): Place {
        val end = range.full.to
        val shown = if (range.isZoomed) range.moved(end - range.visible.width, end) else range
        return copy(range = shown, cursors = cursors.pinnedAt(end))
    }

    /** Removes the first of these that exists: selection, second cursor, pinned cursor, cursor. */
    internal fun cancelled(): Place = if (selection == null) copy(cursors = cursors.cancelled()) else copy(selection = null)
}

/** The names of a finding that begins at [x]. */
data class WantedFinding(val rule: String, val topic: String?, val x: Double)

/** A change of a person's place in a log, other than by a key: by a gesture, list, video or file. See [Place]. */
sealed interface PlaceAction : Action {
    /** Shows all of [full], as for another log: without cursor, selection and finding. */
    class Open(val full: Span) : PlaceAction

    /** Shows a log that has grown to [full]. If [isOtherAxis] is true, the x axis is another one, and all of it is shown. */
    class Grow(val full: Span, val isOtherAxis: Boolean = false) : PlaceAction

    /** Goes to the end of the log, and stays there if the log grows. */
    object GoToEnd : PlaceAction

    /** Goes to the end of a log that has grown; going back skips this. */
    object FollowEnd : PlaceAction

    /** Keeps the visible range while the log grows. */
    object Pause : PlaceAction

    /** Pins the cursor at [x], or at the nearest end of the log. Shows it, with its surroundings if [isWithSurroundings] is true. */
    class GoTo(val x: Double, val isWithSurroundings: Boolean = false) : PlaceAction

    /** Selects [finding] where the person is; null for none. */
    class Visit(val finding: FindingPlace<Finding>?) : PlaceAction

    /** Pins the cursors at [x] and [second], where they were when the log was left; the visible range stays. */
    class Pin(val x: Double, val second: Double?) : PlaceAction

    /** Shows x between [from] and [to], in any order; going back returns from it. */
    class Show(val from: Double, val to: Double) : PlaceAction

    /** Shows the selected range. */
    object ShowSelection : PlaceAction

    /** Remembers the visible range for going back, at the start of a gesture of many steps. */
    object Remember : PlaceAction

    /** Shows x between [from] and [to], in any order, as one of many steps. */
    class Move(val from: Double, val to: Double) : PlaceAction

    /** Moves the visible range by [distance] in x, backwards if negative, as one of many steps. */
    class Shift(val distance: Double) : PlaceAction

    /** Makes the visible range [factor] times as wide around [center], as one of many steps. */
    class Scale(val factor: Double, val center: Double) : PlaceAction

    /** Shows [range], to which a gesture has led, or in which it began. */
    class Range internal constructor(internal val range: Viewport) : PlaceAction

    /** Selects [span]; null for nothing. */
    class Select(val span: Span?) : PlaceAction

    /** Moves the pointer to [x]. */
    class Hover(val x: Double) : PlaceAction

    /** Removes the pointer, which left the graphs. */
    object Leave : PlaceAction

    /** Clicks [x], or shift-clicks it, see [Cursors.clicked]. */
    class Click(val x: Double, val reach: Double, val isShifted: Boolean) : PlaceAction

    /** Clicks [x] in the overview: pins the cursor there, and shows it in the middle if it is not visible. */
    class Pick(val x: Double) : PlaceAction

    /** Moves the cursor at which values are read to [x]; a pinned one stays pinned. */
    class MoveCursor(val x: Double) : PlaceAction

    /** Restores the cursors as they were before the first click of a double click. */
    class Point internal constructor(internal val cursors: Cursors) : PlaceAction

    /** Removes the first of these that exists: selection, second cursor, pinned cursor, cursor. */
    object Cancel : PlaceAction
}
