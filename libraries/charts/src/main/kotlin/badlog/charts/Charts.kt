package badlog.charts

import badlog.charts.kind.BATTERY_TREND
import badlog.charts.kind.ChartKind
import badlog.charts.kind.LINK_TREND
import badlog.charts.kind.RESISTANCE_TREND
import badlog.charts.kind.batteryOverCurrent
import badlog.charts.kind.loopBoxes
import badlog.charts.kind.loopHistogram
import badlog.charts.kind.motorTemperatures
import badlog.charts.kind.trendOf
import badlog.charts.look.Chart
import badlog.charts.match.ChartedLog
import badlog.charts.match.matchesOf

/**
 * The charts of a folder of logs.
 *
 * @property all the charts with enough data, the most useful first.
 * @property lacking for each other chart, a sentence about the missing data.
 * @property undrawn the names of the other charts.
 */
class Charts internal constructor(val all: List<Chart>, val lacking: List<String>, val undrawn: List<String>)

/**
 * Returns the charts of [logs], with their matches in the order of play.
 *
 * @param checkpoint called before each chart; an exception from it stops the work and is passed on.
 */
fun chartsOf(logs: List<ChartedLog>, checkpoint: () -> Unit = {}): Charts {
    val matches = matchesOf(logs)
    val made = KINDS.map { kind ->
        checkpoint()
        kind.of(matches)
    }
    val (drawn, others) = made.partition { it.chart != null }
    return Charts(drawn.mapNotNull { it.chart }, others.map { it.lacking }, others.map { it.name })
}

private val KINDS = listOf(
    ChartKind { trendOf(it, BATTERY_TREND) },
    ChartKind(::loopHistogram),
    ChartKind(::loopBoxes),
    ChartKind(::batteryOverCurrent),
    ChartKind { trendOf(it, RESISTANCE_TREND) },
    ChartKind { trendOf(it, LINK_TREND) },
    ChartKind(::motorTemperatures),
)
