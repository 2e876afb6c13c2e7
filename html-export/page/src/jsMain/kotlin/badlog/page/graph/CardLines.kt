package badlog.page.graph

import badlog.core.analysis.Graph
import badlog.page.dom.ResizeObserver
import badlog.page.dom.element
import badlog.page.parts.PartNodes
import badlog.page.parts.patch
import badlog.page.view.Scene
import badlog.page.view.SearchedGraph
import badlog.viewer.panel.Measured
import badlog.viewer.panel.MeasuredLine
import badlog.viewer.panel.NamedSpan
import badlog.viewer.panel.Part
import badlog.viewer.panel.measured
import badlog.viewer.panel.statisticsOf
import badlog.viewer.shown.comparison.ComparedGraph
import badlog.viewer.shown.comparison.comparedGraph
import badlog.viewer.shown.search.Query
import badlog.viewer.shown.statistics.textOf
import badlog.viewer.state.StatisticsState
import badlog.viewer.text.shortNames
import org.w3c.dom.HTMLElement

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

/** The statistics of the lines of a graph, see [statisticsOf], between the cursors A and B or otherwise over the visible range. */
internal class StatisticsTable(compared: ComparedGraph, private val scene: Scene) {
    private val lines = compared.graph.series.zip(shortNames(compared.names)).mapIndexed { i, (line, name) ->
        MeasuredLine(line, name, compared.colors[i])
    }
    private val nodes = PartNodes(scene.palette) { action ->
        scene.store.send(action)
        update()
    }
    private var parts = emptyList<Part>()
    private var shown: Pair<NamedSpan, StatisticsState>? = null

    val element: HTMLElement = element("div", "statistics")

    init {
        ResizeObserver(::repaint).observe(element)
    }

    private val wanted get() = scene.store.state.run { place.measured to statistics }

    /** Whether the statistics are about an earlier range. */
    val isOutdated: Boolean get() = shown != wanted

    /** Calculates the current statistics. */
    fun update() {
        val (part, choice) = wanted.also { shown = it }
        val channels = scene.channels.takeIf { channels -> lines.any { it.line.topic.name in channels.topics } }
        val measured = Measured(listOf(lines), listOf(lines), channels)
        parts = statisticsOf(measured, part, scene.xAxis, choice, scene.store.state.unfolded)
        repaint()
    }

    /** Redraws the histograms in the current colors. */
    fun repaint() = element.patch(nodes.of(parts))

    /** Returns how long lane [index] was in each state over the current range, as lines of text. */
    fun hintOf(index: Int): String = lines[index].run { runs.textOf(line.states.orEmpty(), wanted.first.span, scene.xAxis) }
}
