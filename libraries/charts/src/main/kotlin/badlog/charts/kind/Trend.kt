package badlog.charts.kind

import badlog.charts.look.Chart
import badlog.charts.look.ChartColors
import badlog.charts.look.ChartTexts
import badlog.charts.look.Limit
import badlog.charts.look.PlotArea
import badlog.charts.look.PointLabel
import badlog.charts.look.emptyPlot
import badlog.charts.look.matchAxis
import badlog.charts.look.matchRange
import badlog.charts.look.withLabels
import badlog.charts.look.withLimit
import badlog.charts.match.ChartedMatch
import badlog.charts.match.ChartedMatches
import badlog.charts.match.MIN_MATCHES
import badlog.rules.number.LogNumbers
import badlog.rules.number.Measure
import org.jetbrains.letsPlot.geom.geomErrorBar
import org.jetbrains.letsPlot.geom.geomHLine
import org.jetbrains.letsPlot.geom.geomLine
import org.jetbrains.letsPlot.geom.geomPoint
import org.jetbrains.letsPlot.geom.geomRect
import org.jetbrains.letsPlot.intern.Plot
import org.jetbrains.letsPlot.tooltips.tooltipsNone

/**
 * A chart of a number over the matches, with its median and the band of the middle half.
 *
 * @property texts its texts.
 * @property what the measurement that a log needs for it, as part of a sentence.
 * @property isWorseBelow whether small values are the bad ones; otherwise large ones are.
 * @property limit the value at which the number becomes a problem; null for none.
 * @property uncertainty returns the uncertainty of the number; NaN for none.
 * @property number returns the number; NaN for none.
 */
internal class Trend(
    val texts: ChartTexts,
    val what: String,
    val isWorseBelow: Boolean,
    val limit: Limit? = null,
    val uncertainty: (LogNumbers) -> Double = { Double.NaN },
    val number: (LogNumbers) -> Double,
)

internal val BATTERY_TREND = Trend(
    ChartTexts("battery", "Battery at its lowest", "How is the battery doing over the event?", "Lowest voltage while enabled (V)"),
    "the battery’s voltage",
    isWorseBelow = true,
    limit = Limit(6.75, "brownout, 6.75 V"),
) { it.of("battery", Measure.LOWEST) }

internal val RESISTANCE_TREND = Trend(
    ChartTexts("resistance", "Resistance of battery and wiring", "Is a battery worn out, or a lead loose?", "Resistance (mΩ)"),
    "battery voltage and a total current that varies",
    isWorseBelow = false,
    limit = Limit(25.0, "worn, 25 mΩ"),
    uncertainty = LogNumbers::uncertainty,
    number = LogNumbers::resistance,
)

internal val LINK_TREND = Trend(
    ChartTexts("packet-loss", "Packet loss", "How good is the link to the field?", "Mean packet loss while enabled (%)"),
    "the share of lost packets",
    isWorseBelow = false,
) { it.of("packet loss", Measure.ENABLED) }

/** Returns the labels of the outliers on the bad side, the farthest first. */
private fun outliersOf(known: List<ChartedMatch>, values: List<Double>, middle: Quartiles, isWorseBelow: Boolean): List<PointLabel> {
    val sign = if (isWorseBelow) -1 else 1
    val fence = if (isWorseBelow) middle.lower - middle.fence else middle.upper + middle.fence
    return known.indices.filter { sign * (values[it] - fence) > 0 }.sortedByDescending { sign * values[it] }.take(MAX_LABELS)
        .map { PointLabel(known[it].place.toDouble(), values[it], known[it].label) }
}

internal fun trendOf(matches: ChartedMatches, trend: Trend): ChartResult {
    val known = matches.all.filter { trend.number(it.numbers).isFinite() }
    if (known.size < MIN_MATCHES) return lacking(trend.texts, trend.what, known.size)
    val values = known.map { trend.number(it.numbers) }
    val middle = Quartiles.of(values)
    val limit = trend.limit?.takeIf { it.isShownWith(values, trend.isWorseBelow) }
    val ends = known.flatMap { trend.ends(it.numbers) }
    val area = PlotArea(matchRange(matches.all), PlotArea.paddedRange(values + ends + listOfNotNull(limit?.value), least = 0.0))
    val bars = if (ends.isEmpty()) null else "bars: 95 % uncertainty"
    val reading = listOfNotNull("band: the middle half", "dashed: the median", bars, limit?.reading).joinToString(" · ")
    val data = mapOf("x" to known.map { it.place }, "y" to values)
    val plot = emptyPlot(trend.texts, matches, known.size, reading)
        .withMiddle(middle, area).withLimit(limit).withUncertainties(known, trend) +
        geomLine(data, color = ChartColors.LINE, size = 0.8, tooltips = tooltipsNone) {
            x = "x"
            y = "y"
        } +
        geomPoint(data, color = ChartColors.LINE, size = if (known.size > MAX_LARGE_POINTS) 2.0 else 3.0, tooltips = tooltipsNone) {
            x = "x"
            y = "y"
        }
    val points = known.indices.map { known[it].place.toDouble() to values[it] }
    val labeled = plot.withLabels(outliersOf(known, values, middle, trend.isWorseBelow), points, area, isBelow = trend.isWorseBelow)
    return ChartResult(Chart(trend.texts, reading, labeled + matchAxis(matches.all) + area.yScale()))
}

/** Returns the ends of the number's uncertainty in [numbers]; nothing if it has none. */
private fun Trend.ends(numbers: LogNumbers): List<Double> {
    val uncertain = uncertainty(numbers)
    return if (uncertain > 0) listOf(number(numbers) - uncertain, number(numbers) + uncertain) else emptyList()
}

private fun Plot.withMiddle(middle: Quartiles, area: PlotArea): Plot {
    val band = mapOf(
        "from" to listOf(area.x.start),
        "to" to listOf(area.x.endInclusive),
        "low" to listOf(middle.lower),
        "high" to listOf(middle.upper),
    )
    return this + geomRect(band, fill = ChartColors.BAND, size = 0.0, tooltips = tooltipsNone) {
        xmin = "from"
        xmax = "to"
        ymin = "low"
        ymax = "high"
    } + geomHLine(yintercept = middle.median, color = ChartColors.MUTED, linetype = "dashed", size = 0.6, tooltips = tooltipsNone)
}

private fun Plot.withUncertainties(known: List<ChartedMatch>, trend: Trend): Plot {
    val uncertain = known.filter { trend.uncertainty(it.numbers) > 0 }
    if (uncertain.isEmpty()) return this
    val data = mapOf(
        "x" to uncertain.map { it.place },
        "low" to uncertain.map { trend.number(it.numbers) - trend.uncertainty(it.numbers) },
        "high" to uncertain.map { trend.number(it.numbers) + trend.uncertainty(it.numbers) },
    )
    return this + geomErrorBar(data, color = ChartColors.LINE, width = 0.25, alpha = 0.6, tooltips = tooltipsNone) {
        x = "x"
        ymin = "low"
        ymax = "high"
    }
}

private const val MAX_LARGE_POINTS = 40
private const val MAX_LABELS = 20
