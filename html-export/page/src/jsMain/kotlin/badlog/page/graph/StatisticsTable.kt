package badlog.page.graph

import badlog.page.dom.ResizeObserver
import badlog.page.dom.element
import badlog.page.parts.PartNodes
import badlog.page.parts.patch
import badlog.page.view.Scene
import badlog.viewer.panel.Measured
import badlog.viewer.panel.MeasuredLine
import badlog.viewer.panel.NamedSpan
import badlog.viewer.panel.Part
import badlog.viewer.panel.measured
import badlog.viewer.panel.statisticsOf
import badlog.viewer.shown.comparison.ComparedGraph
import badlog.viewer.shown.statistics.textOf
import badlog.viewer.state.StatisticsState
import badlog.viewer.text.shortNames
import org.w3c.dom.HTMLElement

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
