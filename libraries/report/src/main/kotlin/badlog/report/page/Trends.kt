package badlog.report.page

import badlog.rules.number.FigureKey
import badlog.rules.number.LogFigures
import badlog.rules.number.Measure

/** Returns small plots of the battery, the loop and the figures that differed most, over [logs], in order; empty for none. */
internal fun trends(logs: List<IndexedLog>): String {
    val measured = logs.filter { it.report.figures.keys.isNotEmpty() }
    val plots = (FIXED + mostDifferent(measured)).mapNotNull { trend ->
        val points = measured.map { log ->
            val figures = log.report.figures
            val key = trend.keyIn(figures)
            val uncertainty = if (key?.measure == Measure.RESISTANCE) figures.uncertainty else Double.NaN
            TrendPoint(log.shortName, key?.let(figures::get) ?: Double.NaN, uncertainty, isOdd = key in log.report.differences.figures)
        }
        trendPlot(trend.title, trend.unit, points)
    }
    return if (plots.isEmpty()) "" else "<div class=\"trends\">\n${plots.joinToString("")}</div>\n"
}

/** A plot over the matches: for each, the figure that [keyIn] selects. */
private class Trend(val title: String, val unit: String, val keyIn: (LogFigures) -> FigureKey?)

private fun trendOf(title: String, unit: String, signal: String, measure: Measure) =
    Trend(title, unit) { figures -> figures.keys.find { it.signal == signal && it.measure == measure } }

private val FIXED = listOf(
    trendOf("Battery at its lowest", "V", "battery", Measure.LOWEST),
    trendOf("Resistance of battery and wiring", "mΩ", FigureKey.RESISTANCE, Measure.RESISTANCE),
    trendOf("Loop time, 95th percentile", "ms", "loop time", Measure.PERCENTILE95),
)

/** Returns the figures that were findings in the most logs; if none was, the robot's current. */
private fun mostDifferent(logs: List<IndexedLog>): List<Trend> {
    val found = logs.flatMap { it.report.differences.figures }.filter { it.signal !in FIXED_SIGNALS }
    val most = found.groupingBy { it }.eachCount().entries.sortedByDescending { it.value }.take(MOST).map { (key, _) ->
        Trend("${key.topic} ${key.measure.words}", key.unit) { figures -> key.takeIf { it in figures.keys } }
    }
    return most.ifEmpty { listOf(trendOf("Total current in teleop", "A", "total current", Measure.TELEOP)) }
}

private val FIXED_SIGNALS = setOf("battery", FigureKey.RESISTANCE, "loop time")
private const val MOST = 3
