package badlog.window.folder.index

import badlog.core.analysis.meant
import badlog.core.recording.Value
import badlog.files.matchInName
import badlog.signals.vocabulary.LoggedMatch

/**
 * The match that a log is of. Each property is null if unknown.
 *
 * @property event the event, such as `Mill Creek Regional`.
 * @property type the type, such as `Qualification`.
 * @property number the number of the match; usually digits, but `2-1` for the first match of the second semifinal.
 * @property alliance `Red` or `Blue` if it can be recognized, otherwise as logged.
 */
internal data class MatchFacts(
    val event: String? = null,
    val type: String? = null,
    val number: String? = null,
    val alliance: String? = null,
) {
    /** The match within its event: `Qualification 42`; null without a number. */
    val match: String? get() = number?.let { "${type ?: "Match"} $it" }

    companion object {
        /** Returns the facts in [logged], with the alliance from [values], and otherwise from the name of the file. */
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
