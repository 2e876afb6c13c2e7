package badlog.page.view

import badlog.viewer.shown.search.Query
import badlog.viewer.text.countText

/** The number of matches of a [Query] on the page, by kind. */
internal class SearchCounts(
    val graphs: Int = 0,
    val values: Int = 0,
    val events: Int = 0,
    val findings: Int = 0,
    val topics: Int = 0,
    val notes: Int = 0,
) {
    val isEmpty: Boolean get() = sum == 0

    /** The total. */
    val sum: Int get() = graphs + values + events + findings + topics + notes

    operator fun plus(other: SearchCounts): SearchCounts = SearchCounts(
        graphs + other.graphs,
        values + other.values,
        events + other.events,
        findings + other.findings,
        topics + other.topics,
        notes + other.notes,
    )

    /** Returns the text for readers, such as `3 graphs, 1 event`. */
    fun text(): String {
        val parts = listOf(
            "graph" to graphs,
            "topic" to topics,
            "value" to values,
            "event" to events,
            "finding" to findings,
            "note" to notes,
        ).filter { it.second > 0 }
        return if (parts.isEmpty()) "nothing matches" else parts.joinToString { (name, number) -> countText(number, name) }
    }
}
