package badlog.charts.match

import badlog.rules.number.LogNumbers
import badlog.signals.match.MatchKind
import badlog.signals.match.NaturalOrder

/**
 * A match in charts.
 *
 * @property label its name on an axis: short and unique.
 * @property place its place in the order of play, from 1.
 */
internal class ChartedMatch(val label: String, val place: Int, val numbers: LogNumbers)

/**
 * The matches of charts, in the order of play.
 *
 * @property event their event, empty if it is unknown or differs.
 * @property others the number of logs left out because they are not of a match.
 */
internal class ChartedMatches(val all: List<ChartedMatch>, val event: String, val others: Int)

/**
 * Returns the matches of [logs] in the order of play. Logs without measurements, such as a test bench's, are left out. So is practice if
 * there are enough matches, because a robot is driven differently in practice.
 */
internal fun matchesOf(logs: List<ChartedLog>): ChartedMatches {
    val measured = logs.filter { it.numbers.keys.isNotEmpty() || it.numbers.distributions.isNotEmpty() }
    val played = measured.filter { it.numbers.kind == MatchKind.MATCH }.takeIf { it.size >= MIN_MATCHES } ?: measured
    val ordered = played.sortedWith(PLAYING_ORDER)
    // Logs of an unknown event may be of another one.
    val events = ordered.map { it.match.event?.trim().orEmpty() }.distinctBy { it.lowercase() }
    val labels = labelsOf(ordered)
    val matches = ordered.mapIndexed { place, log -> ChartedMatch(labels[place], place + 1, log.numbers) }
    return ChartedMatches(matches, events.singleOrNull()?.let { plainText(it, MAX_EVENT) }.orEmpty(), measured.size - played.size)
}

/** The smallest number of matches for a chart; fewer are clearer as numbers. */
internal const val MIN_MATCHES = 3

/** By time; matches of unknown time come last, by round and number. */
private val PLAYING_ORDER = compareBy<ChartedLog> { it.began ?: Long.MAX_VALUE }
    .thenBy { if (it.match.number == null) Int.MAX_VALUE else roundOf(it) }
    .thenBy(NaturalOrder) { it.match.number.orEmpty() }
    .thenBy(NaturalOrder) { it.file }

/** The maximum length of a name in the line below a chart. */
private const val MAX_EVENT = 36
