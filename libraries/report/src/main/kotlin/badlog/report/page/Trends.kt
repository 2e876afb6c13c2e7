package badlog.report.page

import badlog.rules.number.LogNumbers
import badlog.rules.number.Measure
import badlog.rules.number.NumberKey

/** Returns small plots of the battery, the loop and the numbers that differed most, over [logs], in order. Empty for none. */
internal fun trends(logs: List<IndexedLog>): String {
    val measured = logs.filter { it.report.numbers.keys.isNotEmpty() }
    val plots = (FIXED + mostDifferent(measured)).mapNotNull { trend ->
        val points = measured.map { log ->
            val numbers = log.report.numbers
            val key = trend.keyIn(numbers)
            val uncertainty = if (key?.measure == Measure.RESISTANCE) numbers.uncertainty else Double.NaN
            TrendPoint(log.shortName, key?.let(numbers::get) ?: Double.NaN, uncertainty, isOdd = key in log.report.differences.numbers)
        }
        trendPlot(trend.title, trend.unit, points)
    }
    return if (plots.isEmpty()) "" else "<div class=\"trends\">\n${plots.joinToString("")}</div>\n"
}

/** A plot over the matches: for each, the number that [keyIn] selects. */
private class Trend(val title: String, val unit: String, val keyIn: (LogNumbers) -> NumberKey?)

private fun trendOf(title: String, unit: String, signal: String, measure: Measure) =
    Trend(title, unit) { numbers -> numbers.keys.find { it.signal == signal && it.measure == measure } }

private val FIXED = listOf(
    trendOf("Battery at its lowest", "V", "battery", Measure.LOWEST),
    trendOf("Resistance of battery and wiring", "mΩ", NumberKey.RESISTANCE, Measure.RESISTANCE),
    trendOf("Loop time, 95th percentile", "ms", "loop time", Measure.PERCENTILE95),
)

/** Returns the numbers that were findings in the most logs; if none was, the robot's current. */
private fun mostDifferent(logs: List<IndexedLog>): List<Trend> {
    val found = logs.flatMap { it.report.differences.numbers }.filter { it.signal !in FIXED_SIGNALS }
    val most = found.groupingBy { it }.eachCount().entries.sortedByDescending { it.value }.take(MAX_VARYING).map { (key, _) ->
        Trend("${key.topic} ${key.measure.words}", key.unit) { numbers -> key.takeIf { it in numbers.keys } }
    }
    return most.ifEmpty { listOf(trendOf("Total current in teleop", "A", "total current", Measure.TELEOP)) }
}

private val FIXED_SIGNALS = setOf("battery", NumberKey.RESISTANCE, "loop time")
private const val MAX_VARYING = 3
