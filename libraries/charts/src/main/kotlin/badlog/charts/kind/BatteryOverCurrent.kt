package badlog.charts.kind

import badlog.charts.look.Chart
import badlog.charts.look.ChartColors
import badlog.charts.look.ChartTexts
import badlog.charts.look.PlotArea
import badlog.charts.look.PointLabel
import badlog.charts.look.emptyPlot
import badlog.charts.look.withLabels
import badlog.charts.look.within
import badlog.charts.match.ChartedMatch
import badlog.charts.match.ChartedMatches
import badlog.charts.match.MIN_MATCHES
import badlog.rules.number.Measure
import org.jetbrains.letsPlot.geom.geomLine
import org.jetbrains.letsPlot.geom.geomPoint
import org.jetbrains.letsPlot.intern.Plot
import org.jetbrains.letsPlot.tooltips.tooltipsNone

/** Returns a chart of each match's lowest voltage over the current drawn. */
internal fun batteryOverCurrent(matches: ChartedMatches): ChartResult {
    val known = matches.all.filter { currentOf(it).isFinite() && voltageOf(it).isFinite() }
    if (known.size < MIN_MATCHES) return lacking(TEXTS, "the battery’s voltage and the total current", known.size)
    val (currents, voltages) = known.map(::currentOf) to known.map(::voltageOf)
    val usual = if (known.size >= MIN_LINE_POINTS) TheilSenLine.through(currents, voltages) else null
    val reading = "each point is a match" + if (usual != null) " · far below the dashed line: weak battery, loose lead" else ""
    val area = PlotArea(PlotArea.paddedRange(currents), PlotArea.paddedRange(voltages))
    val plot = emptyPlot(TEXTS, matches, known.size, reading).withLine(usual, area) +
        geomPoint(mapOf("x" to currents, "y" to voltages), color = ChartColors.LINE, size = 3.0, tooltips = tooltipsNone) {
            x = "x"
            y = "y"
        }
    // The lowest first, since there is not always room for all.
    val labeled = if (known.size <= MAX_LABELED) known else known.sortedBy(::voltageOf).take(LABELS_OF_MANY)
    val labels = labeled.sortedBy(::voltageOf).map { PointLabel(currentOf(it), voltageOf(it), it.label) }
    val marked = plot.withLabels(labels, currents.zip(voltages), area)
    return ChartResult(Chart(TEXTS, reading, marked.within(area)))
}

private fun Plot.withLine(usual: TheilSenLine?, area: PlotArea): Plot {
    // The library draws nothing of a line that leaves the chart.
    val (from, to) = usual?.within(area.x, area.y) ?: return this
    val ends = mapOf("x" to listOf(from, to), "y" to listOf(usual.at(from), usual.at(to)))
    return this + geomLine(ends, color = ChartColors.MUTED, linetype = "dashed", size = 0.6, tooltips = tooltipsNone) {
        x = "x"
        y = "y"
    }
}

private fun currentOf(match: ChartedMatch) = match.numbers.distributionOf("total current")?.percentile95 ?: Double.NaN

private fun voltageOf(match: ChartedMatch) = match.numbers.of("battery", Measure.LOWEST)

private val TEXTS = ChartTexts(
    "battery-over-current",
    "Lowest voltage over current",
    "Does the battery sag because the robot draws more?",
    y = "Lowest voltage while enabled (V)",
    x = "Current exceeded 5 % of the time (A)",
)

/** A line through fewer points would only follow them. */
private const val MIN_LINE_POINTS = 6
private const val MAX_LABELED = 30
private const val LABELS_OF_MANY = 15
