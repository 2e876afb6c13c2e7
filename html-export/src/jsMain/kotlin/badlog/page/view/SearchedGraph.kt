package badlog.page.view

import badlog.analysis.Graph
import badlog.plot.search.Query
import badlog.plot.text.unitText

/** What a search finds of [graph]: by its name, by the names and units of its lines, and by what these are. */
internal class SearchedGraph(private val graph: Graph, private val scene: Scene) {
    private val title = "${graph.name} ${unitText(graph.unit)}"
    private val texts by lazy { graph.series.map { "$title ${it.topic.name} ${unitText(it.unit)}".lowercase() } }

    /** Which of its lines [query] finds by themselves. */
    fun linesFoundBy(query: Query): List<Boolean> =
        graph.series.mapIndexed { i, line -> query.matchesLowercase(texts[i], scene.traitsOf(line, query)) }

    /** Whether [query] finds it: a line of it, or all of them together. */
    fun isFoundBy(query: Query): Boolean = linesFoundBy(query).any { it } ||
        query.matchesLowercase(texts.joinToString(" "), graph.series.flatMapTo(HashSet()) { scene.traitsOf(it, query) })
}
