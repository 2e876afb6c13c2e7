package badlog.viewer.library.index

import badlog.analysis.meant
import badlog.file.matchInName
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
        /** Returns what [logged] tells, the alliance what [values] tell, and for what neither does, the name of the file. */
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
