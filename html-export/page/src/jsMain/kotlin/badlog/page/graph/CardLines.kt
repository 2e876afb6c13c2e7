package badlog.page.graph

import badlog.core.analysis.Graph
import badlog.page.view.Scene
import badlog.page.view.SearchedGraph
import badlog.viewer.shown.comparison.comparedGraph
import badlog.viewer.shown.search.Query

/**
 * The lines of a graph, also from compared logs: which are drawn, their entries in the legend, and their statistics.
 *
 * @param own the graph of the page's own log.
 * @param lines the board's names for the lines of [own], in order.
 * @param onToggle called with the board's name of a line that a person wants to hide or show.
 */
internal class CardLines(own: Graph, lines: List<String>, scene: Scene, onToggle: (List<String>) -> Unit) {
    private val compared = comparedGraph(own, lines, scene.compared)
    private val searched = SearchedGraph(compared.graph, scene)
    private var found: List<Boolean>? = null

    /** The graph with the lines of all logs. */
    val graph: Graph = compared.graph

    /** Whether each line is drawn, in the order of the lines. */
    val isShown: BooleanArray = BooleanArray(graph.series.size)

    /** The index of each line's color. */
    val colors: List<Int> = compared.colors

    val statistics: StatisticsTable = StatisticsTable(compared, scene)
    val legend: Legend = Legend(compared, statistics::hintOf) { onToggle(compared.lines.slice(it..it)) }

    /** Draws all lines except [hidden] lines and lines that a search did not find. */
    fun show(hidden: Set<String>) {
        for (i in isShown.indices) isShown[i] = compared.lines[i] !in hidden && found?.get(i) != false
        legend.show(isShown)
    }

    /** Limits [show] to the lines that [query] matches by themselves, if there are any. Returns whether these lines have changed. */
    fun search(query: Query): Boolean {
        val lines = searched.linesFoundBy(query)
        val wanted = lines.takeIf { found -> found.any { it } && !found.all { it } }
        if (wanted == found) return false
        found = wanted
        legend.list(wanted)
        return true
    }

    /** Returns whether [query] matches the graph. */
    fun isFoundBy(query: Query): Boolean = searched.isFoundBy(query)
}
