package badlog.page.view

import badlog.core.analysis.Graph
import badlog.viewer.shown.search.Query
import badlog.viewer.text.unitText

/** What a search finds in [graph]: by its name, by the names and units of its lines, and by their traits. */
internal class SearchedGraph(private val graph: Graph, private val scene: Scene) {
    private val title = "${graph.name} ${unitText(graph.unit)}"
    private val texts by lazy { graph.series.map { "$title ${it.topic.name} ${unitText(it.unit)}".lowercase() } }

    /** Returns which of its lines [query] finds by themselves. */
    fun linesFoundBy(query: Query): List<Boolean> =
        graph.series.mapIndexed { i, line -> query.matchesLowercase(texts[i], scene.traitsOf(line, query)) }

    /** Returns whether [query] finds it: one of its lines, or all of them together. */
    fun isFoundBy(query: Query): Boolean = linesFoundBy(query).any { it } ||
        query.matchesLowercase(texts.joinToString(" "), graph.series.flatMapTo(HashSet()) { scene.traitsOf(it, query) })
}
