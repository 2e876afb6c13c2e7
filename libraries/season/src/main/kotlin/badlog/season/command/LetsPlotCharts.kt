package badlog.season.command

import badlog.charts.chartsOf
import badlog.charts.match.ChartedLog
import badlog.cli.plugin.ChartService
import badlog.report.LogReport
import badlog.report.page.PageChart
import badlog.report.page.PageCharts

/** Provides the program with charts, through lets-plot. */
public class LetsPlotCharts : ChartService {
    override fun chartsOf(logs: List<LogReport>, progress: (done: Int, total: Int) -> Unit): PageCharts {
        // Charts are drawn without a screen.
        System.setProperty("java.awt.headless", "true")
        val charts = chartsOf(logs.map { ChartedLog(it.match, it.file.name, it.began, it.numbers) })
        progress(0, charts.all.size)
        val drawn = charts.all.mapIndexed { place, chart ->
            val done = PageChart(chart.name, chart.title, chart.question, chart.reading, chart.svg(), chart.png())
            progress(place + 1, charts.all.size)
            done
        }
        return PageCharts(drawn, charts.lacking, charts.undrawn)
    }
}
