package badlog.viewer.library.index

import badlog.analysis.meant
import badlog.recording.Value
import badlog.rules.signal.LoggedMatch

/**
 * What match a log is of. Each is null when unknown.
 *
 * @property event where, such as `Mill Creek Regional`.
 * @property type such as `Qualification`.
 * @property number of the match; mostly digits, but `2-1` for the first match of the second semifinal.
 * @property alliance `Red` or `Blue` where it can be understood, else as it was logged.
 */
internal data class MatchFacts(
    val event: String? = null,
    val type: String? = null,
    val number: String? = null,
    val alliance: String? = null,
) {
    /** Which match of its event: `Qualification 42`; null without a number. */
    val match: String? get() = number?.let { "${type ?: "Match"} $it" }

    companion object {
        /** What [logged] tells, the alliance what [values] tell, and for what neither does, the name of the file. */
        fun of(values: List<Value>, fileName: String, logged: LoggedMatch?): MatchFacts {
            val named = matchInName(fileName)
            val number = logged?.number
            return MatchFacts(
                event = logged?.event ?: named.event,
                type = logged?.type ?: named.type.takeIf { number == null || number == named.number },
                number = number ?: named.number,
                alliance = values.meant("alliance", "alliance color", "alliance colour", "alliance station")?.let(::color),
            )
        }
    }
}

private fun color(text: String) = when {
    text.startsWith("red", ignoreCase = true) -> "Red"
    text.startsWith("blue", ignoreCase = true) -> "Blue"
    else -> text
}

private val TYPES = listOf(
    "Qualification" to "qualification|qualifier|quals?|qm|q",
    "Quarterfinal" to "quarterfinals?|qf",
    "Semifinal" to "semifinals?|semis?|sf",
    "Final" to "finals?|f",
    "Elimination" to "eliminations?|elims?|e",
    "Playoff" to "playoffs?",
    "Practice" to "practice|prac|pm|p",
    null to "match|m",
)

private val MATCH = Regex(
    "(?<![A-Za-z0-9])(${TYPES.joinToString("|") { it.second }})[-_. #]?0*(\\d{1,3})(?:-?m0*(\\d{1,2}))?(?![A-Za-z0-9])",
    RegexOption.IGNORE_CASE,
)

/** A single word between the date and the match, as WPILib names its logs: `FRC_20240316_104107_MILLC_Q42`. */
private val EVENT = Regex("[-_. ]+([A-Za-z][A-Za-z0-9]{2,})[-_. ]+")

/** What the name of a file tells about the match, such as `qualification-42.bag`, `Q42.bag` and `ohcl_sf2m1.csv`. */
internal fun matchInName(fileName: String): MatchFacts {
    val date = dateInName(fileName)
    // The digits of a date are none of a match's: behind it a match is looked for first.
    val afterDate = date?.let { it.range.last + 1 } ?: 0
    val found = MATCH.find(fileName, afterDate)
        ?: MATCH.find(date?.let { fileName.substring(0, it.range.first) } ?: return MatchFacts())
        ?: return MatchFacts()
    val (word, number, second) = found.destructured
    val type = TYPES.first { (_, words) -> Regex(words, RegexOption.IGNORE_CASE).matches(word) }.first
    val event = if (date == null || found.range.first < afterDate) {
        null
    } else {
        EVENT.matchEntire(fileName.substring(afterDate, found.range.first))?.groupValues?.get(1)
    }
    return MatchFacts(event, type, if (second.isEmpty()) number else "$number-$second")
}
