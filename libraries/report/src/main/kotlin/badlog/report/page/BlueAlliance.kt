package badlog.report.page

import badlog.signals.match.MatchOfLog
import badlog.signals.match.MatchType

/**
 * Returns the address of [match], in [year], on The Blue Alliance, a site with the results of all matches. It is the address of the event if only
 * that is certain. Null if the event is unknown or not named by its code, and for practice matches, which the site does not have.
 */
internal fun blueAllianceOf(match: MatchOfLog, year: Int?): String? {
    val type = match.type?.let(MatchType::of)
    val code = match.event?.trim()?.takeIf(CODE::matches)?.lowercase()
    if (code == null || year == null || type == null || type in NOT_LISTED) return null
    val event = "$year${DIVISIONS[code] ?: code}"
    val key = matchKey(type, match.number.orEmpty(), year) ?: return "$SITE/event/$event"
    return "$SITE/match/${event}_$key"
}

/** Returns the name of a match within its event; null if [number] does not tell. */
private fun matchKey(type: MatchType, number: String, year: Int): String? {
    val numbers = NUMBER.matchEntire(number.trim())?.destructured?.toList().orEmpty().filter { it.isNotEmpty() }.map { it.toInt() }
    val first = numbers.firstOrNull() ?: return null
    val second = numbers.getOrNull(1)
    return when (type) {
        MatchType.QUALIFICATION -> if (second == null) "qm$first" else null

        MatchType.FINAL -> "f1m${second ?: first}"

        MatchType.QUARTERFINAL -> second?.let { "qf${first}m$it" }

        // In a double elimination, each number is a match of its own.
        MatchType.SEMIFINAL -> (second ?: 1.takeIf { year >= DOUBLE_ELIMINATION })?.let { "sf${first}m$it" }

        else -> null
    }
}

private const val SITE = "https://www.thebluealliance.com"
private const val DOUBLE_ELIMINATION = 2023
private val NOT_LISTED = setOf(MatchType.PRACTICE, MatchType.TEST)

/** The form of the codes that fields send as names of events. */
private val CODE = Regex("[A-Z][A-Z0-9]{2,9}")
private val NUMBER = Regex("(\\d{1,3})(?:-(\\d{1,2}))?")

/** The divisions of the championship, and their codes on the site where these are others. */
private val DIVISIONS = mapOf(
    "archimedes" to "arc",
    "carson" to "cars",
    "carver" to "carv",
    "curie" to "cur",
    "daly" to "dal",
    "darwin" to "dar",
    "galileo" to "gal",
    "hopper" to "hop",
    "johnson" to "joh",
    "milstein" to "mil",
    "newton" to "new",
    "roebling" to "roe",
    "tesla" to "tes",
    "turing" to "tur",
)
