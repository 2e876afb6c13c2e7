package badlog.signals.json

import badlog.core.json.JsonMember
import badlog.core.json.JsonValue

/** Thrown for text that this module did not write. */
class UnreadableJsonException : Exception()

/** The members of a required object. */
class JsonFields(members: List<JsonMember>?) {
    private val values = (members ?: throw UnreadableJsonException()).associate { it.key to it.value }

    fun find(key: String): JsonValue? = values[key]

    fun string(key: String): String = optional(key) ?: throw UnreadableJsonException()

    fun optional(key: String): String? = values[key]?.text

    fun number(key: String): Int = values[key]?.json?.toIntOrNull() ?: throw UnreadableJsonException()

    fun isTrue(key: String): Boolean = values[key]?.json == "true"

    /** Returns an empty list if there is none. */
    fun <T> list(key: String, read: (JsonValue) -> T): List<T> = values[key]?.let { itemsOf(it).map(read) }.orEmpty()

    fun strings(key: String): List<String> = list(key, ::stringOf)
}

fun itemsOf(value: JsonValue): List<JsonValue> = value.items ?: throw UnreadableJsonException()

fun stringOf(value: JsonValue): String = value.text ?: throw UnreadableJsonException()

/** Returns an object of those [members] that have a value. */
fun jsonObject(vararg members: Pair<String, String?>): String =
    members.filter { it.second != null }.joinToString(",", "{", "}") { "\"${it.first}\":${it.second}" }

fun <T> jsonArray(items: List<T>, json: (T) -> String): String = items.joinToString(",", "[", "]", transform = json)

/** Returns [items] as a JSON array; null if there are none, so that the member is left out. */
fun <T> jsonList(items: List<T>, json: (T) -> String): String? = if (items.isEmpty()) null else jsonArray(items, json)
