package badlog.analysis

import badlog.recording.PathName
import badlog.recording.Value

/**
 * What match a recording is of, from the values that teams log under these names: `OHCL Qualification 42`. Null when no
 * value tells.
 */
public fun matchTitle(values: List<Value>): String? {
    fun find(vararg names: String): String? = values
        .firstOrNull { value -> normalized(PathName.baseNameOf(value.name)) in names && isMeant(value.text) }
        ?.text?.trim()

    val event = find("event name", "event")
    val type = find("match type")
    val number = find("match number", "match")
    if (event == null && number == null) return null
    val match = if (number == null) type else "${type ?: "Match"} $number"
    return listOfNotNull(event, match).joinToString(" ")
}

private fun normalized(name: String) = name.replace('_', ' ').lowercase()

// Without a field, robots log what the driver station gives them: nothing, 0 or None.
private fun isMeant(text: String) = text.isNotBlank() && text.trim() !in setOf("0", "None", "null")
