package badlog.cli.plugin

import badlog.report.LogReport
import badlog.report.page.PageCharts

/** Draws charts of many logs, for `badlog report --charts`. */
public interface ChartService {
    /**
     * Returns the charts of [logs].
     *
     * @param progress called with the number of charts that are done. An exception from it stops the work and is passed on.
     */
    public fun chartsOf(logs: List<LogReport>, progress: (done: Int, total: Int) -> Unit): PageCharts
}
