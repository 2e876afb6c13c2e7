package badlog.viewer.state

import badlog.core.analysis.Span
import badlog.rules.Finding
import badlog.viewer.choices.range.Viewport
import badlog.viewer.draw.mark.FindingPlace
import badlog.viewer.shown.cursor.Cursors

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
