package badlog.signals.match

/** The forms of each type in the names of files; null for a match of an unknown one. */
private val TYPES: List<Pair<MatchType?, String>> =
    MatchType.entries.filter { it.inNames.isNotEmpty() }.map { it to it.inNames } + (null to "match|m")

private val MATCH = Regex(
    "(?<![A-Za-z0-9])(${TYPES.joinToString("|") { it.second }})[-_. #]?0*(\\d{1,3})(?:-?m0*(\\d{1,2}))?(?![A-Za-z0-9])",
    RegexOption.IGNORE_CASE,
)

/** A single word between the date and the match, as in the names of WPILib's logs: `FRC_20240316_104107_MILLC_Q42`. */
private val EVENT = Regex("[-_. ]+([A-Za-z][A-Za-z0-9]{2,})[-_. ]+")

/**
 * Returns the code of an event in [start], in capitals or with its year. It must be the only word that is not common in names of logs; otherwise
 * null.
 */
private fun eventBefore(start: String): String? {
    val word = start.split(Regex("[-_. ]+")).filter { it.isNotEmpty() && it.lowercase() !in COMMON }.singleOrNull() ?: return null
    if (NO_EVENT.matches(word)) return null
    return CODE.matchEntire(word)?.groupValues?.drop(1)?.first { it.isNotEmpty() }
}

private val CODE = Regex("([A-Z][A-Z0-9]{2,})|20\\d\\d([A-Za-z][A-Za-z0-9]{2,})")

/** The words that may stand where an event's code may be, such as an alliance or a team. */
private val NO_EVENT = Regex("(red|blue|alliance|team|comp|competition|practice|quals|elims)\\d*", RegexOption.IGNORE_CASE)
private val COMMON =
    setOf("log", "logs", "frc", "ftc", "robot", "rio", "roborio", "bag", "badlog", "akit", "match", "data", "test", "day", "rev", "run")

/** Returns the match in the name of a file, such as `qualification-42.bag`, `Q42.bag`, `ohcl_sf2m1.csv` and `MIKET_Q12_rio.wpilog`. */
fun matchInName(fileName: String): MatchOfLog {
    val date = dateInName(fileName)
    // The digits of a date do not belong to a match, so a match is searched for after it first.
    val afterDate = date?.let { it.range.last + 1 } ?: 0
    val found = MATCH.find(fileName, afterDate)
        ?: MATCH.find(date?.let { fileName.substring(0, it.range.first) } ?: return MatchOfLog())
        ?: return MatchOfLog()
    val (word, number, second) = found.destructured
    val type = TYPES.first { (_, words) -> Regex(words, RegexOption.IGNORE_CASE).matches(word) }.first
    val event = if (date == null || found.range.first < afterDate) {
        eventBefore(fileName.substring(0, found.range.first))
    } else {
        EVENT.matchEntire(fileName.substring(afterDate, found.range.first))?.groupValues?.get(1)?.takeUnless(NO_EVENT::matches)
    }
    return MatchOfLog(event, type?.title, if (second.isEmpty()) number else "$number-$second")
}
