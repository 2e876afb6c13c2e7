package badlog.charts.match

import badlog.signals.match.MatchType
import badlog.viewer.text.dateText

/** Returns a label for each of [logs], such as `Q42`; no two are equal. */
internal fun labelsOf(logs: List<ChartedLog>): List<String> {
    val taken = HashSet<String>()
    val days = logs.filter { numberOf(it).isEmpty() }.mapNotNullTo(HashSet()) { it.began?.floorDiv(DAY) }
    return logs.map { log ->
        val label = shortName(log, hasDay = days.size > 1)
        generateSequence(1) { it + 1 }.map { if (it == 1) label else "$label ($it)" }.first(taken::add)
    }
}

/** Returns the rank of the match type of [log] in the order of play. Practice is first, the final last. */
internal fun roundOf(log: ChartedLog): Int = typeOf(log)?.round ?: QUALIFICATION

private fun typeOf(log: ChartedLog): MatchType? = log.match.type?.let { MatchType.of(it) }

private fun numberOf(log: ChartedLog) = log.match.number?.let { plainText(it, MAX_NUMBER) }.orEmpty()

private fun shortName(log: ChartedLog, hasDay: Boolean): String {
    val number = numberOf(log)
    if (number.isNotEmpty()) return (typeOf(log)?.prefix ?: "M") + number
    // Names of logs without a match differ mostly in the time, and are too long for an axis.
    return log.began?.let { timeText(it, hasDay) }
        ?: shortenedInMiddle(plainText(log.file.substringBefore('.'), MAX_FILE)).ifEmpty { "log" }
}

/** Returns the time of [second] as `12:34`, or, with its day, as `16 Mar, 12:34`. */
private fun timeText(second: Long, hasDay: Boolean): String {
    val (date, time) = dateText(second).split(", ")
    return if (hasDay) "${date.substringBeforeLast(' ')}, $time" else time
}

/** Returns [name], shortened in the middle if it is too long, because names of logs differ at their end. */
private fun shortenedInMiddle(name: String): String =
    if (name.length <= MAX_LABEL) name else name.take(BEGIN_OF_NAME).trim() + "…" + name.takeLast(MAX_LABEL - BEGIN_OF_NAME - 1).trim()

/**
 * Returns [text] from a file without characters of markup, shortened to [max] characters. The library that draws charts interprets tags and
 * formulas in texts.
 */
internal fun plainText(text: String, max: Int): String {
    val plain = text.map { if (it.isLetterOrDigit() || it in PLAIN) it else ' ' }.joinToString("").replace(Regex(" {2,}"), " ").trim()
    return if (plain.length <= max) plain else plain.take(max - 1).trim() + "…"
}

/** The prefix that The Blue Alliance and teams use for matches of this type. Practice is not P, because P1 could also be a playoff. */
private val MatchType.prefix: String
    get() = when (this) {
        MatchType.PRACTICE -> "Pr"
        MatchType.TEST -> "T"
        MatchType.QUALIFICATION -> "Q"
        MatchType.QUARTERFINAL -> "QF"
        MatchType.SEMIFINAL -> "SF"
        MatchType.FINAL -> "F"
        MatchType.ELIMINATION, MatchType.PLAYOFF -> "E"
    }

private val MatchType.round: Int
    get() = when (this) {
        MatchType.PRACTICE, MatchType.TEST -> 0
        MatchType.QUALIFICATION -> QUALIFICATION
        MatchType.QUARTERFINAL, MatchType.ELIMINATION, MatchType.PLAYOFF -> 2
        MatchType.SEMIFINAL -> 3
        MatchType.FINAL -> 4
    }

/** The round of matches of an unknown type, too. */
private const val QUALIFICATION = 1

private const val PLAIN = " -_.,:+#/()'’"

/** Sets of a playoff, such as 2-1, are short. */
private const val MAX_NUMBER = 6
private const val MAX_LABEL = 14
private const val BEGIN_OF_NAME = 4

/** File systems allow names of 255 characters. */
private const val MAX_FILE = 255
private const val DAY = 86_400L
