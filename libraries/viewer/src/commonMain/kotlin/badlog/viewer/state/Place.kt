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
