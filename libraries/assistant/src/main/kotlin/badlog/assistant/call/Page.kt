package badlog.assistant.call

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObjectBuilder
import kotlinx.serialization.json.put

/**
 * A part of a list that is too long for one answer.
 *
 * @property entries the entries of that part.
 * @property total the number of entries in the whole list.
 * @property next the index at which the next part begins; null for the last one.
 */
internal class Page(val entries: List<JsonElement>, val total: Int, val next: Int?) {
    /** Adds the list to an answer under [name], with the total and the index of the next part. */
    fun putInto(answer: JsonObjectBuilder, name: String) {
        answer.put(name, JsonArray(entries))
        answer.put("total", total)
        if (next != null) answer.put("nextOffset", next)
    }

    companion object {
        /** The parameters of tools with such a list. */
        val PARAMETERS: List<Parameter> = listOf(
            Parameter("offset", ParameterType.WHOLE, "Number of entries to skip; default 0. Use “nextOffset” of the previous answer."),
            Parameter("limit", ParameterType.WHOLE, "Maximum number of entries, 1 to $MAX_ENTRIES; default $DEFAULT_ENTRIES."),
        )

        private const val MAX_ENTRIES = 200
        private const val DEFAULT_ENTRIES = 50

        /** The maximum number of characters in such a part, if it has more than one entry. */
        private const val MAX_CHARACTERS = 24_000

        /** Returns the part of [items] that [arguments] ask for, converted by [json]. */
        fun <T> of(items: List<T>, arguments: Arguments, json: (List<T>) -> List<JsonElement>): Page {
            val offset = arguments.whole("offset", 0, 0..Int.MAX_VALUE)
            val limit = arguments.whole("limit", DEFAULT_ENTRIES, 1..MAX_ENTRIES)
            val entries = ArrayList<JsonElement>()
            var size = 0
            for (entry in json(items.drop(offset).take(limit))) {
                size += entry.toString().length
                if (size > MAX_CHARACTERS && entries.isNotEmpty()) break
                entries += entry
            }
            return Page(entries, items.size, (offset + entries.size).takeIf { it < items.size && entries.isNotEmpty() })
        }
    }
}
