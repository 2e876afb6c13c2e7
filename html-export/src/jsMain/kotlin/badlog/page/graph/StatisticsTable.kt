package badlog.page.graph

import badlog.analysis.Graph
import badlog.analysis.SeriesStatistics
import badlog.analysis.statistics
import badlog.page.dom.add
import badlog.page.dom.element
import badlog.page.view.Palette
import badlog.page.view.Scene
import badlog.plot.text.countText
import badlog.plot.text.roundedText
import org.w3c.dom.HTMLElement

/** What each line of a graph does over the visible part of x, in figures. */
internal class StatisticsTable(private val graph: Graph, private val scene: Scene) {
    val element: HTMLElement = element("div", "statistics")

    /** Calculates the figures for what is visible now. */
    fun update() {
        val now = scene.range.now
        element.textContent = ""
        element.add("table") {
            add("caption", "", "${scene.xNumber(now.from)} – ${scene.xText(now.to)}")
            add("thead").add("tr") {
                add("th", "", "Line")
                for (column in COLUMNS) add("th", "", column.title).title = column.hint
            }
            add("tbody") {
                graph.series.forEachIndexed { index, series ->
                    val figures = series.data.statistics(now.from, now.to)
                    add("tr") {
                        add("th") {
                            setAttribute("scope", "row")
                            add("span", "swatch line-${index % Palette.LINES}")
                            add("span", "", series.name)
                        }
                        for (column in COLUMNS) add("td", "", column.text(figures))
                    }
                }
            }
        }
    }

    private class Column(val title: String, val hint: String, val text: (SeriesStatistics) -> String)

    private companion object {
        val COLUMNS = listOf(
            Column("min", "the smallest value") { roundedText(it.min) },
            Column("max", "the largest value") { roundedText(it.max) },
            Column("mean", "the arithmetic mean of the samples") { roundedText(it.mean) },
            Column("std", "the standard deviation of the samples") { roundedText(it.standardDeviation) },
            Column("5 %", "5 % of the samples are below this") { roundedText(it.percentile5) },
            Column("median", "half of the samples are below this") { roundedText(it.median) },
            Column("95 %", "95 % of the samples are below this") { roundedText(it.percentile95) },
            Column("first", "the first value") { roundedText(it.first) },
            Column("last", "the last value") { roundedText(it.last) },
            Column("integral", "the area under the samples") { roundedText(it.integral) },
            Column("samples", "how many samples have a value") { countText(it.count) },
            Column("gaps", "how many have none") { countText(it.gaps) },
        )
    }
}
