package badlog.viewer.shown.finding

import badlog.core.analysis.Span
import badlog.rules.Finding
import badlog.viewer.text.countText

/**
 * The places of the finding in the order in which a person steps through them. That is the order of x, even if another place is the one to
 * look at first.
 */
val Finding.placesInOrder: List<Span> get() = places.sortedBy { it.from }

/**
 * Returns the number of [place] among the finding's places, such as `3 of 12`. It is for a person who steps through them. If the finding
 * occurred more often than at the known places, its count follows: `3 of 100, found 1200 times`. An unknown place counts as the first one.
 */
fun Finding.placeNumber(place: Span): String {
    val steps = placesInOrder
    val number = "${countText(maxOf(0, steps.indexOf(place)) + 1)} of ${countText(steps.size)}"
    return if (spanCount > steps.size) "$number, found ${countText(spanCount)} times" else number
}
