package badlog.viewer.shown.finding

import badlog.core.analysis.Span
import badlog.rules.Finding
import badlog.viewer.text.countText

/** Its places in the order in which a person steps through them: that of x, even if another one is to look at first. */
val Finding.placesInOrder: List<Span> get() = places.sortedBy { it.from }

/**
 * Returns which of its places [place] is, such as `3 of 12`, for a person who steps through them; with the number of times that it was
 * found, if those are more than the places that are known: `3 of 100, found 1200 times`. The first for a place that is none of them.
 */
fun Finding.placeNumber(place: Span): String {
    val steps = placesInOrder
    val number = "${countText(maxOf(0, steps.indexOf(place)) + 1)} of ${countText(steps.size)}"
    return if (spanCount > steps.size) "$number, found ${countText(spanCount)} times" else number
}
