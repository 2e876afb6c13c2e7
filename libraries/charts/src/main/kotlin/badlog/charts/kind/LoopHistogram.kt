package badlog.charts.kind

import badlog.charts.look.Chart
import badlog.charts.look.ChartColors
import badlog.charts.look.ChartTexts
import badlog.charts.look.PlotArea
import badlog.charts.look.PointLabel
import badlog.charts.look.emptyPlot
import badlog.charts.look.withLabels
import badlog.charts.match.ChartedMatches
import badlog.charts.match.MIN_MATCHES
import badlog.rules.number.Distribution
import badlog.viewer.text.exactText
import badlog.viewer.text.fixedText
import org.jetbrains.letsPlot.geom.geomRect
import org.jetbrains.letsPlot.geom.geomVLine
import org.jetbrains.letsPlot.scale.scaleFillManual
import org.jetbrains.letsPlot.scale.scaleYLog10
import org.jetbrains.letsPlot.tooltips.tooltipsNone
import kotlin.math.floor
import kotlin.math.log10
import kotlin.math.pow

/** Returns a histogram of loop times over all matches together. */
internal fun loopHistogram(matches: ChartedMatches): ChartResult {
    val known = matches.all.mapNotNull { it.numbers.distributionOf(LOOP_TIME) }.filter { it.binWidth > 0 && it.seconds.sum() > 0 }
    if (known.size < MIN_MATCHES) return lacking(TEXTS, "the loop time", known.size)
    val shares = sharesOf(known)
    val width = known.first().binWidth
    val last = shares.size - 1
    // Empty bins at the right end would only squeeze the others; the last one contains everything larger.
    val end = maxOf((LOOP_LIMIT / width).toInt() + BINS_BEHIND, shares.indexOfLast { it > 0 } + 2)
    val shown = shares.take(end)
    val late = shares.filterIndexed { bin, _ -> bin * width >= LATE_MILLIS }.sum()
    val reading = "${shareText(late)} of the time in loops over ${LATE_MILLIS.toInt()} ms" +
        if (shares[last] > 0) " · rightmost bar: all that took longer" else ""
    val floor = floorOf(shares)
    val bars = shown.indices.filter { shown[it] > floor }
    val data = mapOf(
        "from" to bars.map { (it + GAP) * width },
        "to" to bars.map { (it + 1 - GAP) * width },
        "floor" to bars.map { floor },
        "share" to bars.map { shown[it] },
        "late" to bars.map { if (it * width >= LATE_MILLIS) "late" else "in time" },
    )
    val ticks = generateSequence(PERCENT) { it / TEN }.takeWhile { it > floor * HALF }.toList()
    val area = PlotArea(0.0..shown.size * width, log10(floor)..log10(PERCENT * HEADROOM))
    val plot = emptyPlot(TEXTS, matches, known.size, reading) +
        geomRect(data, size = 0.0, tooltips = tooltipsNone, showLegend = false) {
            xmin = "from"
            xmax = "to"
            ymin = "floor"
            ymax = "share"
            fill = "late"
        } +
        scaleFillManual(listOf(ChartColors.LINE, ChartColors.LIMIT), breaks = listOf("in time", "late")) +
        geomVLine(xintercept = LOOP_LIMIT, color = ChartColors.LIMIT, linetype = "dashed", tooltips = tooltipsNone) +
        area.xScale() +
        // Without logarithms, the loops that a team looks for would be too rare to be seen.
        scaleYLog10(breaks = ticks, labels = ticks.map(::exactText), limits = floor to PERCENT * HEADROOM, expand = listOf(0, 0))
    val label = PointLabel(LOOP_LIMIT + area.xAt(LABEL_POINTS), log10(PERCENT), "a loop has 20 ms")
    return ChartResult(Chart(TEXTS, reading, plot.withLabels(listOf(label), emptyList(), area, isLogarithmic = true)))
}

/**
 * Returns the start of the axis, in percent. The smallest of [shares] is above it, so that a single loop in a hundred matches has a bar.
 */
private fun floorOf(shares: List<Double>): Double {
    val least = shares.filter { it > 0 }.min()
    return TEN.pow(floor(log10(least * HALF))).coerceIn(MIN_FLOOR, MAX_FLOOR)
}

/** Returns the share of each bin in the time of all logs together, in percent. */
private fun sharesOf(known: List<Distribution>): List<Double> {
    val bins = known.maxOf { it.seconds.size }
    val seconds = List(bins) { bin -> known.sumOf { it.seconds.getOrElse(bin) { 0.0 } } }
    return seconds.map { PERCENT * it / seconds.sum() }
}

private fun shareText(percent: Double): String = when {
    percent == 0.0 -> "none"
    percent < MIN_SHARE -> "less than 0.1 %"
    else -> "${fixedText(percent, 1)} %"
}

internal const val LOOP_TIME = "loop time"

/** The time available for a loop, in ms. */
internal const val LOOP_LIMIT = 20.0

/**
 * The time in ms above which a loop counts as late. Some logs have the time between loops instead, and half of those exceed 20 ms slightly.
 */
private const val LATE_MILLIS = 21.0
private val TEXTS = ChartTexts(
    "loop-times",
    "Loop times of all matches",
    "Do loops overrun, and by how much?",
    y = "Share of the time enabled (%)",
    x = "Loop time (ms)",
)
private const val PERCENT = 100.0

/** In percent; a smaller share is described in words. */
private const val MIN_SHARE = 0.1

/** The limits for the start of the axis, in percent. The upper one makes charts of few loops look like others. */
private const val MAX_FLOOR = 0.001
private const val MIN_FLOOR = 0.00001
private const val TEN = 10.0
private const val HALF = 0.5

/** The minimum number of bins after the limit. */
private const val BINS_BEHIND = 5

/** Half of the gap between two bars, as a share of a bar. */
private const val GAP = 0.05
private const val HEADROOM = 1.6

/** The distance of the limit's label from its line, in points. */
private const val LABEL_POINTS = 70.0
