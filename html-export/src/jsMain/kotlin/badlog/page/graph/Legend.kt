package badlog.page.graph

import badlog.analysis.Graph
import badlog.analysis.GraphSeries
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.element
import badlog.page.dom.isHidden
import badlog.page.dom.showText
import badlog.page.view.Cursor
import badlog.plot.axis.graphAxes
import badlog.plot.color.LINE_COLORS
import badlog.plot.cursor.indexAt
import badlog.plot.cursor.textOf
import badlog.plot.text.exactText
import badlog.plot.text.roundedText
import badlog.plot.text.shortNames
import badlog.plot.text.unitText
import org.w3c.dom.HTMLElement

/**
 * The lines of a graph by name and color, each with its value at the cursor, read from the samples themselves.
 *
 * @param onToggle is called with the place of a line that a person wants to hide, or to see again.
 */
internal class Legend(private val graph: Graph, private val onToggle: (Int) -> Unit) {
    // The title says it already where a graph has but one line.
    val element: HTMLElement = element("div", if (graph.series.size == 1) "legend is-single" else "legend")
    private val names = legendNames(graph)
    private val values = ArrayList<HTMLElement>()
    private val units = ArrayList<HTMLElement>()
    private val entries = graph.series.mapIndexed { index, series -> addEntry(index, series) }

    private fun addEntry(index: Int, series: GraphSeries): HTMLElement =
        element.addButton("legend-entry", "", "${series.topic.name} – press to hide or show this line") { onToggle(index) }.apply {
            setAttribute("data-series", series.name)
            add("span", "swatch line-${index % LINE_COLORS}")
            add("bdi", "legend-name", names[index])
            values += add("span", "value")
            units += add("bdi", "unit graph-unit")
        }

    /** Says which lines are drawn, by [isShown] for each, and by which axis. */
    fun show(isShown: BooleanArray) {
        entries.forEachIndexed { index, entry -> entry.setAttribute("aria-pressed", isShown[index].toString()) }
        if (graph.showsStates) return
        val axes = graphAxes(graph.series.mapIndexed { index, series -> series.unit.takeIf { isShown[index] } })
        for (unit in units) unit.showText("")
        // One unit stands above all of them.
        if (axes.size == 1 && axes[0].unit == unitText(graph.unit)) return
        for (axis in axes) for (line in axis.lines) units[line].showText(axis.legend)
    }

    /** Lists only the lines that are [found]; all for null. */
    fun list(found: List<Boolean>?) = entries.forEachIndexed { index, entry -> entry.isHidden = found?.get(index) == false }

    /** Shows the values at [cursor]. */
    fun update(cursor: Cursor) {
        graph.series.forEachIndexed { index, series ->
            values[index].showText(if (cursor.isPlaced) valueAt(series, cursor.x) else "")
        }
    }

    private fun valueAt(series: GraphSeries, x: Double): String =
        series.textOf(series.indexAt(x)) { if (graph.isVirtual) roundedText(it) else exactText(it) }
}

/** What the lines of [graph] are called where they stand together. */
internal fun legendNames(graph: Graph): List<String> = shortNames(graph.series.map { if (it.isDerived) it.name else it.topic.name })
