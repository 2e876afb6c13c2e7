package badlog.page.graph

import badlog.core.analysis.Graph
import badlog.core.analysis.GraphSeries
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.addName
import badlog.page.dom.element
import badlog.page.dom.isHidden
import badlog.page.dom.showText
import badlog.page.view.Cursor
import badlog.viewer.draw.axis.graphAxes
import badlog.viewer.draw.color.LINE_COLORS
import badlog.viewer.draw.figure.LegendEntry
import badlog.viewer.shown.comparison.ComparedGraph
import badlog.viewer.shown.cursor.Cursors
import badlog.viewer.shown.cursor.comparisonText
import badlog.viewer.shown.cursor.indexAt
import badlog.viewer.shown.cursor.textOf
import badlog.viewer.text.exactText
import badlog.viewer.text.numberText
import badlog.viewer.text.shortNames
import badlog.viewer.text.unitText
import org.w3c.dom.HTMLElement

/**
 * The lines of a graph by name and color. Each has its value at the cursor, read from the original samples.
 *
 * @param statesOf returns the number and duration of a lane's states, as text.
 * @param onToggle called with the index of a line to hide or show.
 */
internal class Legend(compared: ComparedGraph, private val statesOf: (Int) -> String, private val onToggle: (Int) -> Unit) {
    private val graph = compared.graph
    private val colors = compared.colors

    // If a graph has only one line, the title already names it.
    val element: HTMLElement = element("div", if (graph.series.size == 1) "legend is-single" else "legend")
    private val names = shortNames(compared.names)
    private val values = ArrayList<HTMLElement>()
    private val units = ArrayList<HTMLElement>()
    private var cursors = Cursors()
    private var xUnit = ""
    private val entries = graph.series.mapIndexed { index, series -> addEntry(index, series) }

    private fun addEntry(index: Int, series: GraphSeries): HTMLElement {
        val hint = "${series.topic.name} – press to hide or show this line"
        return element.addButton("legend-entry", "", hint) { onToggle(index) }.apply {
            setAttribute("data-series", series.name)
            add("span", "swatch line-${colors[index] % LINE_COLORS}")
            addName(names[index], "legend-name")
            values += add("span", "value")
            units += add("bdi", "unit graph-unit")
            addEventListener("pointerenter", {
                val more = if (graph.showsStates) statesOf(index) else textOf(series, ::exactText)
                title = if (more.isEmpty()) hint else "$hint\n$more"
            })
        }
    }

    /** Shows the drawn lines, according to [isShown], and the axis of each. */
    fun show(isShown: BooleanArray) {
        entries.forEachIndexed { index, entry -> entry.setAttribute("aria-pressed", isShown[index].toString()) }
        if (graph.showsStates) return
        val axes = graphAxes(graph.series.mapIndexed { index, series -> series.unit.takeIf { isShown[index] } })
        for (unit in units) unit.showText("")
        // A single unit is in the title.
        if (axes.size == 1 && axes[0].unit == unitText(graph.unit)) return
        for (axis in axes) for (line in axis.lines) units[line].showText(axis.side.legendOf(axis.unit))
    }

    /** Lists only the lines for which [found] is true; null lists all lines. */
    fun list(found: List<Boolean>?) = entries.forEachIndexed { index, entry -> entry.isHidden = found?.get(index) == false }

    /** Shows the values at [cursor], with x in [xUnit]; compares them if there is a second cursor. */
    fun update(cursor: Cursor, xUnit: String) {
        cursors = cursor.now
        this.xUnit = xUnit
        graph.series.forEachIndexed { index, series -> values[index].showText(textOf(series, ::numberText)) }
    }

    private fun textOf(series: GraphSeries, sampleText: (Double) -> String): String {
        val a = cursors.x ?: return ""
        val b = cursors.second ?: return series.textOf(series.indexAt(a), sampleText)
        return series.comparisonText(a, b, xUnit, sampleText)
    }

    /** Returns the texts of the drawn lines, with their colors if [hasColors]. */
    fun shown(hasColors: Boolean): List<LegendEntry> =
        entries.indices.filter { entries[it].getAttribute("aria-pressed") == "true" }.map { i ->
            val texts = listOf(names[i], values[i].textContent, units[i].textContent).filterNot { it.isNullOrEmpty() }
            LegendEntry(texts.joinToString(" "), if (hasColors) colors[i] else null)
        }
}

/** Returns the full name of [graph], with the type and metadata of its first topic. */
internal fun hintOf(graph: Graph): String {
    val topic = graph.series[0].topic
    return listOf(graph.name, topic.type, topic.metadata).filter { it.isNotEmpty() }.joinToString("\n")
}
