package badlog.core.analysis

import badlog.core.recording.PathName
import badlog.core.recording.Value

/**
 * Returns the title of a recording's match, such as `OHCL Qualification 42`, from values that teams usually log. Null if [values] name
 * neither event nor match.
 */
public fun matchTitle(values: List<Value>): String? =
    matchTitle(values.firstText("event name", "event"), values.firstText("match type"), values.firstText("match number", "match"))

/** Returns the title of match [number] of [type] at [event]; null if there is neither event nor number. */
public fun matchTitle(event: String?, type: String?, number: String?): String? {
    if (event == null && number == null) return null
    val match = if (number == null) type else "${type ?: "Match"} $number"
    return listOfNotNull(event, match).joinToString(" ")
}

/**
 * Returns the first meaningful text among the values with one of these [names], see [isMeaningful]; null if there is none. [names] are in
 * lower case and without folders.
 */
public fun List<Value>.firstText(vararg names: String): String? =
    firstOrNull { PathName.baseNameOf(it.name).replace('_', ' ').lowercase() in names && isMeaningful(it.text) }?.text?.trim()

/**
 * Returns whether [text] says anything about a match. Off the field, the Driver Station provides a blank text, 0 or None, and robots log
 * that.
 */
public fun isMeaningful(text: String): Boolean = text.isNotBlank() && text.trim().lowercase() !in MEANINGLESS

private val MEANINGLESS = setOf("0", "none", "null", "invalid", "unknown")
