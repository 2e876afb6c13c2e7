package badlog.page.graph

import badlog.analysis.Graph
import badlog.analysis.GraphSeries
import badlog.page.dom.add
import badlog.page.dom.addButton
import badlog.page.dom.element
import badlog.page.dom.showText
import badlog.page.view.Cursor
import badlog.plot.color.LINE_COLORS
import badlog.plot.cursor.indexAt
import badlog.plot.cursor.textOf
import badlog.plot.text.exactText
import badlog.plot.text.roundedText
import badlog.plot.text.unitText
import org.w3c.dom.HTMLElement

/**
 * The lines of a graph by name and color, each with its value at the cursor, read from the samples themselves.
 * Pressing one hides its line.
 *
 * @param isShown for each series whether its line is drawn.
 */
internal class Legend(private val graph: Graph, private val isShown: BooleanArray, private val onToggle: () -> Unit) {
    // The title says it already where a graph has but one line.
    val element: HTMLElement = element("div", if (graph.series.size == 1) "legend is-single" else "legend")
    private val values = graph.series.mapIndexed { index, series -> addEntry(index, series) }

    private fun addEntry(index: Int, series: GraphSeries): HTMLElement {
        lateinit var value: HTMLElement
        element.addButton("legend-entry", "", "${series.topic.name} – press to hide or show this line") {}.apply {
            setAttribute("data-series", series.name)
            setAttribute("aria-pressed", "true")
            add("span", "swatch line-${index % LINE_COLORS}")
            add("bdi", "legend-name", series.name)
            value = add("span", "value")
            if (series.unit != graph.unit) add("bdi", "unit", unitText(series.unit))
            addEventListener("click", {
                isShown[index] = !isShown[index]
                setAttribute("aria-pressed", isShown[index].toString())
                onToggle()
            })
        }
        return value
    }

    /** Shows the values at [cursor]. */
    fun update(cursor: Cursor) {
        graph.series.forEachIndexed { index, series ->
            values[index].showText(if (cursor.isPlaced) valueAt(series, cursor.x) else "")
        }
    }

    private fun valueAt(series: GraphSeries, x: Double): String =
        series.textOf(series.indexAt(x)) { if (graph.isVirtual) roundedText(it) else exactText(it) }
}
