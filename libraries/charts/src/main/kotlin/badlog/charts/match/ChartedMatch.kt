package badlog.charts.match

import badlog.rules.number.LogFigures
import badlog.signals.match.NaturalOrder

/**
 * A match in charts.
 *
 * @property label its name on an axis: short, and different from those of all others.
 * @property place its place in the order of play, from 1.
 */
internal class ChartedMatch(val label: String, val place: Int, val figures: LogFigures)

/** The matches of charts, in the order of play; [event] is where they were played, empty if that is unknown or differs. */
internal class ChartedMatches(val all: List<ChartedMatch>, val event: String)

/** Returns the matches of [logs] in the order of play; without logs in which nothing was measured, such as those of a test bench. */
internal fun matchesOf(logs: List<ChartedLog>): ChartedMatches {
    val measured = logs.filter { it.figures.keys.isNotEmpty() || it.figures.distributions.isNotEmpty() }
    val ordered = measured.sortedWith(compareBy<ChartedLog> { it.began }.thenBy(NaturalOrder) { it.file })
    val events = ordered.mapNotNullTo(LinkedHashSet()) { it.match.event }
    val labels = labelsOf(ordered)
    val matches = ordered.mapIndexed { place, log -> ChartedMatch(labels[place], place + 1, log.figures) }
    return ChartedMatches(matches, events.singleOrNull()?.let { plainText(it, MAX_EVENT) }.orEmpty())
}

/** As long as a name may be in the line below a chart. */
private const val MAX_EVENT = 36
