package badlog.page.view

import badlog.core.analysis.Graph
import badlog.viewer.shown.search.Query
import badlog.viewer.text.countText
import badlog.viewer.text.unitText

/** The searchable text of [graph]: its name, the names and units of its lines, and their traits. */
internal class SearchedGraph(private val graph: Graph, private val scene: Scene) {
    private val title = "${graph.name} ${unitText(graph.unit)}"
    private val texts by lazy { graph.series.map { "$title ${it.topic.name} ${unitText(it.unit)}".lowercase() } }

    /** Returns for each line whether [query] matches it alone. */
    fun linesFoundBy(query: Query): List<Boolean> =
        graph.series.mapIndexed { i, line -> query.matchesLowercase(texts[i], scene.traitsOf(line, query)) }

    /** Returns whether [query] matches one of the graph's lines, or all of them together. */
    fun isFoundBy(query: Query): Boolean = linesFoundBy(query).any { it } ||
        query.matchesLowercase(texts.joinToString(" "), graph.series.flatMapTo(HashSet()) { scene.traitsOf(it, query) })
}

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
