package badlog.page.view

import badlog.plot.search.Query
import badlog.plot.text.countText

/** How much of the page a [Query] found. */
internal data class Hits(
    val graphs: Int = 0,
    val values: Int = 0,
    val events: Int = 0,
    val findings: Int = 0,
    val topics: Int = 0,
    val notes: Int = 0,
) {
    val isEmpty: Boolean get() = sum == 0

    /** How many there are in all. */
    val sum: Int get() = graphs + values + events + findings + topics + notes

    operator fun plus(other: Hits): Hits = Hits(
        graphs + other.graphs,
        values + other.values,
        events + other.events,
        findings + other.findings,
        topics + other.topics,
        notes + other.notes,
    )

    /** As a person reads it: `3 graphs, 1 event`. */
    fun text(): String {
        val parts = ArrayList<String>()
        if (graphs > 0) parts += countText(graphs, "graph")
        if (topics > 0) parts += countText(topics, "topic")
        if (values > 0) parts += countText(values, "value")
        if (events > 0) parts += countText(events, "event")
        if (findings > 0) parts += countText(findings, "finding")
        if (notes > 0) parts += countText(notes, "note")
        return if (parts.isEmpty()) "nothing matches" else parts.joinToString()
    }
}
