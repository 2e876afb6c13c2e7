package badlog.page.view

import badlog.core.analysis.Graph
import badlog.viewer.shown.search.Query
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
