package badlog.window.charts

import badlog.catalog.examine.ExaminedLog
import badlog.catalog.folder.LogEntry
import badlog.charts.chartsOf
import badlog.charts.match.ChartedLog
import badlog.rules.number.LogNumbersReader
import badlog.viewer.catalog.DateSource

/**
 * The charts of some logs.
 *
 * @property all the drawn charts, the most useful first.
 * @property lacking a sentence for each of the other charts, about the data that it lacks.
 * @property unknown the number of logs left out because today's rules have not been run over them.
 */
internal class DrawnCharts(val all: List<DrawnChart>, val lacking: List<String>, val unknown: Int = 0)

/**
 * Draws the charts of [logs]. It takes several seconds: call it off the window's thread. Interrupting its thread stops it.
 *
 * @param examined returns the stored results of a log; null if there are none.
 * @param progress receives the fraction done, 0 to 1.
 */
internal fun drawCharts(logs: List<LogEntry>, examined: (LogEntry) -> ExaminedLog?, progress: (Float) -> Unit): DrawnCharts {
    val reader = LogNumbersReader()
    val known = logs.mapNotNull { entry ->
        stopIfInterrupted()
        val date = entry.summary.date
        val began = date.second.takeIf { date.source != DateSource.FILE_TIME }
        examined(entry)?.let { ChartedLog(entry.summary.match, entry.fileName, began, it.numbers(reader)) }
    }
    val charts = chartsOf(known) { stopIfInterrupted() }
    val drawn = charts.all.mapIndexed { place, chart ->
        stopIfInterrupted()
        val done = DrawnChart(chart.name, chart.title, chart.question, chart.reading, chart.svg(), chart.png())
        progress((place + 1f) / charts.all.size)
        done
    }
    return DrawnCharts(drawn, charts.lacking, logs.size - known.size)
}

private fun stopIfInterrupted() {
    if (Thread.interrupted()) throw InterruptedException()
}
