package badlog.charts.kind

import badlog.charts.look.Chart
import badlog.charts.look.ChartColors
import badlog.charts.look.ChartTexts
import badlog.charts.look.PlotArea
import badlog.charts.look.PointLabel
import badlog.charts.look.emptyPlot
import badlog.charts.look.matchAxis
import badlog.charts.look.matchRange
import badlog.charts.look.withLabels
import badlog.charts.match.ChartedMatches
import badlog.charts.match.MIN_MATCHES
import org.jetbrains.letsPlot.Stat
import org.jetbrains.letsPlot.geom.geomBoxplot
import org.jetbrains.letsPlot.geom.geomHLine
import org.jetbrains.letsPlot.geom.geomPoint
import org.jetbrains.letsPlot.scale.scaleYLog10
import org.jetbrains.letsPlot.tooltips.tooltipsNone
import kotlin.math.log10

/** Returns a chart with a box for each match's loop times. */
internal fun loopBoxes(matches: ChartedMatches): ChartResult {
    val known = matches.all.mapNotNull { match -> match.numbers.distributionOf(LOOP_TIME)?.let { match to it } }
    if (known.size < MIN_MATCHES) return lacking(TEXTS, "the loop time", known.size)
    // A logarithmic axis shows both usual loops and the one that took a second, but not 0.
    fun shown(value: Double) = maxOf(value, MIN_MILLIS)
    val data = mapOf(
        "x" to known.map { (match, _) -> match.place },
        "low" to known.map { (_, loops) -> shown(loops.percentile5) },
        "lower" to known.map { (_, loops) -> shown(loops.lowerQuartile) },
        "middle" to known.map { (_, loops) -> shown(loops.median) },
        "upper" to known.map { (_, loops) -> shown(loops.upperQuartile) },
        "high" to known.map { (_, loops) -> shown(loops.percentile95) },
        "longest" to known.map { (_, loops) -> shown(loops.highest) },
    )
    val from = known.minOf { (_, loops) -> shown(loops.percentile5) }
    val to = maxOf(LOOP_LIMIT, known.maxOf { (_, loops) -> shown(loops.highest) })
    val area = PlotArea(matchRange(matches.all), log10(from / ROOM)..log10(to * ROOM))
    val ticks = TICKS.filter { it in from / ROOM..to * ROOM }
    val plot = emptyPlot(TEXTS, matches, known.size, READING) +
        geomHLine(yintercept = LOOP_LIMIT, color = ChartColors.LIMIT, linetype = "dashed", tooltips = tooltipsNone) +
        geomBoxplot(
            data,
            stat = Stat.identity,
            fill = ChartColors.BAND,
            color = ChartColors.LINE,
            width = 0.6,
            size = 0.6,
            tooltips = tooltipsNone,
        ) {
            x = "x"
            ymin = "low"
            lower = "lower"
            middle = "middle"
            upper = "upper"
            ymax = "high"
            group = "x"
        } +
        geomPoint(data, color = ChartColors.LIMIT, size = if (known.size > MAX_LARGE_POINTS) 1.5 else 2.5, tooltips = tooltipsNone) {
            x = "x"
            y = "longest"
        } +
        scaleYLog10(breaks = ticks, labels = ticks.map { "${it.toInt()}" }, limits = from / ROOM to to * ROOM, expand = listOf(0, 0)) +
        matchAxis(matches.all)
    val longest = known.map { (match, loops) -> PointLabel(match.place.toDouble(), log10(shown(loops.highest)), match.label) }
    val blocked = longest.filter { it.y > log10(BLOCKED_MILLIS) }.sortedByDescending { it.y }
    val labeled = plot.withLabels(blocked, longest.map { it.x to it.y }, area, isLogarithmic = true)
    return ChartResult(Chart(TEXTS, READING, labeled))
}

private val TEXTS = ChartTexts("loops-per-match", "Loop times of each match", "In which match were the loops slow?", y = "Loop time (ms)")
private const val READING = "box: the middle half of the time · whiskers: 5 to 95 % · red: the longest loop · dashed: 20 ms"
private const val MIN_MILLIS = 0.5

/** Motor safety switches motors off after this time, in ms. */
private const val BLOCKED_MILLIS = 100.0
private const val ROOM = 1.3
private const val MAX_LARGE_POINTS = 40
private val TICKS = listOf(1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0, 200.0, 500.0, 1000.0, 2000.0, 5000.0, 10_000.0)
