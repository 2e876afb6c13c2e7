package badlog.analysis

import badlog.recording.PathName
import badlog.recording.Value

/**
 * What match a recording is of, from the values that teams log under these names: `OHCL Qualification 42`. Null when no
 * value says.
 */
public fun matchTitle(values: List<Value>): String? =
    matchTitle(values.meant("event name", "event"), values.meant("match type"), values.meant("match number", "match"))

/** The title of the match [number] of the type [type] of an event; null without an event and a number. */
public fun matchTitle(event: String?, type: String?, number: String?): String? {
    if (event == null && number == null) return null
    val match = if (number == null) type else "${type ?: "Match"} $number"
    return listOfNotNull(event, match).joinToString(" ")
}

/** The text of the first value with one of [names], in lower case and without folders, that means anything; null for none. */
public fun List<Value>.meant(vararg names: String): String? =
    firstOrNull { PathName.baseNameOf(it.name).replace('_', ' ').lowercase() in names && isMeant(it.text) }?.text?.trim()

/** Whether [text] tells anything of a match: without a field, robots log what the driver station gives them, nothing, 0 or None. */
public fun isMeant(text: String): Boolean = text.isNotBlank() && text.trim().lowercase() !in MEANINGLESS

private val MEANINGLESS = setOf("0", "none", "null", "invalid", "unknown")
