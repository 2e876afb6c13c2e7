package badlog.charts.kind

import badlog.charts.look.Chart
import badlog.charts.look.ChartColors
import badlog.charts.look.ChartTexts
import badlog.charts.look.Limit
import badlog.charts.look.PlotArea
import badlog.charts.look.emptyPlot
import badlog.charts.look.matchAxis
import badlog.charts.look.matchRange
import badlog.charts.look.withLimit
import badlog.charts.match.ChartedMatches
import badlog.charts.match.MIN_MATCHES
import badlog.charts.match.distinctNames
import badlog.rules.number.Measure
import badlog.rules.number.NumberKey
import org.jetbrains.letsPlot.geom.geomLine
import org.jetbrains.letsPlot.geom.geomPoint
import org.jetbrains.letsPlot.scale.scaleColorManual
import org.jetbrains.letsPlot.tooltips.tooltipsNone

/** Returns a chart of the highest temperatures in each match, with a line for each of the hottest motors. */
internal fun motorTemperatures(matches: ChartedMatches): ChartResult {
    val known = matches.all.filter { match -> match.numbers.keys.any(::isTemperature) }
    if (known.size < MIN_MATCHES) return lacking(TEXTS, "the temperature of a motor", known.size)
    val keys = known.flatMapTo(LinkedHashSet()) { match -> match.numbers.keys.filter(::isTemperature) }
    val hottest = keys.sortedByDescending { key ->
        known.maxOf { it.numbers[key].takeIf(Double::isFinite) ?: ABSOLUTE_ZERO }
    }.take(MAX_MOTORS)
    val names = hottest.zip(distinctNames(hottest.map { it.topic })).toMap()
    val points = hottest.flatMap { key ->
        known.map { Point(it.place, it.numbers[key], names.getValue(key)) }
    }.filter { it.celsius.isFinite() }
    val data = mapOf("x" to points.map { it.place }, "y" to points.map { it.celsius }, "motor" to points.map { it.motor })
    val values = points.map { it.celsius }
    val limit = HOT.takeIf { it.isShownWith(values, isWorseBelow = false) }
    val motors = if (keys.size > hottest.size) "the ${hottest.size} hottest of ${keys.size} motors" else "each line is a motor"
    val reading = listOfNotNull(motors, limit?.reading).joinToString(" · ")
    val area = PlotArea(matchRange(matches.all), PlotArea.paddedRange(values + listOfNotNull(limit?.value)))
    val plot = emptyPlot(TEXTS, matches, known.size, reading).withLimit(limit) +
        geomLine(data, size = 0.8, tooltips = tooltipsNone) {
            x = "x"
            y = "y"
            color = "motor"
        } +
        geomPoint(data, size = 2.0, tooltips = tooltipsNone) {
            x = "x"
            y = "y"
            color = "motor"
        } +
        scaleColorManual(hottest.indices.map { ChartColors.line(it) }, breaks = hottest.map { names.getValue(it) }) +
        matchAxis(matches.all, AXIS_SHARE) +
        area.yScale()
    return ChartResult(Chart(TEXTS, reading, plot))
}

private class Point(val place: Int, val celsius: Double, val motor: String)

private fun isTemperature(key: NumberKey) = key.signal == "motor temperature" && key.measure == Measure.HIGHEST

private val HOT = Limit(80.0, "hot, 80 °C")
private val TEXTS = ChartTexts(
    "motor-temperatures",
    "Motor temperatures",
    "Which motor gets hot, and does it cool down between matches?",
    y = "Highest while enabled (°C)",
)
private const val ABSOLUTE_ZERO = -273.15
private const val MAX_MOTORS = 6

/** The share of the width for the matches beside the legend. */
private const val AXIS_SHARE = 0.7
