package badlog.page.graph

import badlog.analysis.Graph
import badlog.analysis.statisticsOf
import badlog.page.dom.add
import badlog.page.dom.element
import badlog.page.view.Scene
import badlog.plot.color.LINE_COLORS
import badlog.plot.statistics.Statistic
import badlog.plot.text.countText
import org.w3c.dom.HTMLElement

/** What each line of a graph does over the visible part of x, in figures. */
internal class StatisticsTable(private val graph: Graph, private val scene: Scene) {
    val element: HTMLElement = element("div", "statistics")

    /** Calculates the figures for what is visible now. */
    fun update() {
        val now = scene.range.now
        element.textContent = ""
        element.add("table") {
            add("caption", "", "${scene.xNumber(now.from)} – ${scene.xText(now.to)}. ${Statistic.BY_TIME}")
            add("thead").add("tr") {
                add("th", "", "Line")
                for (statistic in Statistic.entries) add("th", "", statistic.title).title = statistic.hint
            }
            val names = legendNames(graph)
            add("tbody") {
                graph.series.forEachIndexed { index, series ->
                    val statistics = scene.view.statisticsOf(series, now.from, now.to)
                    add("tr") {
                        add("th") {
                            setAttribute("scope", "row")
                            add("span", "swatch line-${index % LINE_COLORS}")
                            add("span", "", names[index])
                        }
                        for (statistic in Statistic.entries) {
                            val isCount = statistic.isCount
                            add(
                                "td",
                                "",
                                if (isCount) countText(statistic.of(statistics).toInt()) else statistic.textOf(statistics, graph.isVirtual),
                            )
                        }
                    }
                }
            }
        }
    }
}
