package badlog.viewer.library.index

import badlog.recording.PathName
import badlog.recording.Value

/**
 * What match a log is of. Each is null when nothing tells.
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
        /** What [values] tell, and for what they do not, the name of the file. */
        fun of(values: List<Value>, fileName: String): MatchFacts {
            val named = matchInName(fileName)
            val number = values.meant("match number", "match")
            return MatchFacts(
                event = values.meant("event name", "event") ?: named.event,
                type = values.meant("match type") ?: named.type.takeIf { number == null || number == named.number },
                number = number ?: named.number,
                alliance = values.meant("alliance", "alliance color", "alliance colour", "alliance station")?.let(::colour),
            )
        }
    }
}

/** The text of the first value with one of [names] that means anything. */
internal fun List<Value>.meant(vararg names: String): String? = firstOrNull { value ->
    PathName.baseNameOf(value.name).replace('_', ' ').lowercase() in names && isMeant(value.text)
}?.text?.trim()

// Without a field, robots log what the driver station gives them.
private fun isMeant(text: String) = text.isNotBlank() && text.trim().lowercase() !in MEANINGLESS

private val MEANINGLESS = setOf("0", "none", "null", "invalid", "unknown")

private fun colour(text: String) = when {
    text.startsWith("red", ignoreCase = true) -> "Red"
    text.startsWith("blue", ignoreCase = true) -> "Blue"
    else -> text
}
