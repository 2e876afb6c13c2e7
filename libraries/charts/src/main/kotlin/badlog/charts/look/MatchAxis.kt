package badlog.charts.look

import badlog.charts.match.ChartedMatch
import org.jetbrains.letsPlot.intern.Scale
import org.jetbrains.letsPlot.scale.scaleXContinuous

/** Returns the range of [matches] on the horizontal axis: one unit for each, in the order of play. */
internal fun matchRange(matches: List<ChartedMatch>): ClosedFloatingPointRange<Double> =
    matches.first().place - BESIDE..matches.last().place + BESIDE

/** Returns the axis of [matches] with a labeled tick for each, or at regular intervals if there are many. It takes [share] of the width. */
internal fun matchAxis(matches: List<ChartedMatch>, share: Double = 1.0): Scale {
    val longest = matches.maxOf { it.label.length }
    val room = maxOf(1, (share * AXIS_CHARACTERS).toInt() / (longest + 2))
    val step = (matches.size + room - 1) / room
    val labeled = matches.filterIndexed { place, _ -> place % step == 0 }
    val range = matchRange(matches)
    return scaleXContinuous(
        breaks = labeled.map { it.place },
        labels = labeled.map { it.label },
        limits = range.start to range.endInclusive,
        expand = listOf(0, 0),
    )
}

/** The number of characters that fit on an axis. */
private const val AXIS_CHARACTERS = 95

/** The space beside the first and the last match. */
private const val BESIDE = 0.6
