package badlog.core.analysis

import badlog.core.recording.PathName
import badlog.core.recording.Value

/**
 * Returns the match that a recording is of, such as `OHCL Qualification 42`, from the values that teams log under these
 * names. Null if no value says.
 */
public fun matchTitle(values: List<Value>): String? =
    matchTitle(values.meant("event name", "event"), values.meant("match type"), values.meant("match number", "match"))

/** Returns the title of the match [number] of the type [type] of an event; null unless there is an event and a number. */
public fun matchTitle(event: String?, type: String?, number: String?): String? {
    if (event == null && number == null) return null
    val match = if (number == null) type else "${type ?: "Match"} $number"
    return listOfNotNull(event, match).joinToString(" ")
}

/**
 * Returns the text of the first value that means anything and is called one of [names], which are in lower case and without folders; null
 * if there is none.
 */
public fun List<Value>.meant(vararg names: String): String? =
    firstOrNull { PathName.baseNameOf(it.name).replace('_', ' ').lowercase() in names && isMeant(it.text) }?.text?.trim()

/**
 * Returns whether [text] says anything about a match: off the field, robots log what the Driver Station provides, which is nothing, 0 or
 * None.
 */
public fun isMeant(text: String): Boolean = text.isNotBlank() && text.trim().lowercase() !in MEANINGLESS

private val MEANINGLESS = setOf("0", "none", "null", "invalid", "unknown")
