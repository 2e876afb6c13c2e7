package badlog.charts.match

import badlog.rules.number.LogNumbers
import badlog.signals.match.MatchKind
import badlog.signals.match.NaturalOrder

/**
 * A match in charts.
 *
 * @property label its name on an axis: short, and different from those of all others.
 * @property place its place in the order of play, from 1.
 */
internal class ChartedMatch(val label: String, val place: Int, val numbers: LogNumbers)

/**
 * The matches of charts, in the order of play.
 *
 * @property event where they were played, empty if that is unknown or differs.
 * @property others how many logs were left out because they are not of a match.
 */
internal class ChartedMatches(val all: List<ChartedMatch>, val event: String, val others: Int)

/**
 * Returns the matches of [logs] in the order of play; without logs in which nothing was measured, such as those of a test bench, and, if
 * there are enough matches, without practice, in which a robot is driven otherwise.
 */
internal fun matchesOf(logs: List<ChartedLog>): ChartedMatches {
    val measured = logs.filter { it.numbers.keys.isNotEmpty() || it.numbers.distributions.isNotEmpty() }
    val played = measured.filter { it.numbers.kind == MatchKind.MATCH }.takeIf { it.size >= LEAST_MATCHES } ?: measured
    val ordered = played.sortedWith(PLAY)
    // Logs of an unknown event may be of another one.
    val events = ordered.map { it.match.event?.trim().orEmpty() }.distinctBy { it.lowercase() }
    val labels = labelsOf(ordered)
    val matches = ordered.mapIndexed { place, log -> ChartedMatch(labels[place], place + 1, log.numbers) }
    return ChartedMatches(matches, events.singleOrNull()?.let { plainText(it, MAX_EVENT) }.orEmpty(), measured.size - played.size)
}

/** The smallest number of matches of which a chart says more than their numbers do. */
internal const val LEAST_MATCHES = 3

/** By time; those whose time is not known are behind the others, by the names of their matches. */
private val PLAY = compareBy<ChartedLog> { it.began ?: Long.MAX_VALUE }
    .thenBy { if (it.match.number == null) Int.MAX_VALUE else roundOf(it) }
    .thenBy(NaturalOrder) { it.match.number.orEmpty() }
    .thenBy(NaturalOrder) { it.file }

/** As long as a name may be in the line below a chart. */
private const val MAX_EVENT = 36
