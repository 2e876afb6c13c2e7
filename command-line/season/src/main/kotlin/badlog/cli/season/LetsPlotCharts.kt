package badlog.cli.season

import badlog.charts.chartsOf
import badlog.charts.match.ChartedLog
import badlog.cli.part.ChartService
import badlog.report.LogReport
import badlog.report.page.PageChart
import badlog.report.page.PageCharts

/** The charts of the library `charts`. */
public class LetsPlotCharts : ChartService {
    override fun chartsOf(logs: List<LogReport>, progress: (done: Int, total: Int) -> Unit): PageCharts {
        val charts = chartsOf(logs.map { ChartedLog(it.match, it.file.name, it.began, it.figures) })
        val drawn = charts.all.mapIndexed { place, chart ->
            progress(place, charts.all.size)
            PageChart(chart.name, chart.title, chart.question, chart.reading, chart.svg(), chart.png())
        }
        return PageCharts(drawn, charts.lacking)
    }
}
