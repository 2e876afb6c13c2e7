package badlog.html.protocol

import badlog.json.JsonMember
import badlog.json.JsonValue

/** Text that is not what the other side of the protocol writes. */
internal class MalformedException : Exception()

internal fun malformed(): Nothing = throw MalformedException()

/** What [read] reads, or null where that meets what it does not expect. */
internal fun <T> unlessMalformed(read: () -> T): T? = try {
    read()
} catch (_: MalformedException) {
    null
} catch (_: IndexOutOfBoundsException) {
    null
} catch (_: IllegalArgumentException) {
    null
}

/** The members of an object that has to be there. */
internal class JsonFields(members: List<JsonMember>?) {
    private val values = (members ?: malformed()).associate { it.key to it.value }

    fun find(key: String): JsonValue? = values[key]

    operator fun get(key: String): JsonValue = values[key] ?: malformed()

    fun <T> list(key: String, read: (JsonValue) -> T): List<T> = (this[key].items ?: malformed()).map(read)
}

internal val JsonValue.string: String get() = text ?: malformed()

internal val JsonValue.number: Double get() = json.toDoubleOrNull() ?: malformed()

internal val JsonValue.boolean: Boolean get() = json.toBooleanStrictOrNull() ?: malformed()

/** An object of those [members] whose JSON is not null. */
internal fun jsonObject(vararg members: Pair<String, String?>): String =
    members.filter { it.second != null }.joinToString(",", "{", "}") { "\"${it.first}\":${it.second}" }

internal fun <T> array(items: List<T>, json: (T) -> String): String = items.joinToString(",", "[", "]", transform = json)

/**
 * [json] as it can stand in a script element: without any `<` it neither ends nor comments it out. Half of a surrogate pair alone
 * cannot be written as UTF-8, so all are escaped.
 */
internal fun inScript(json: String): String {
    if (json.none { it == '<' || it.isSurrogate() }) return json
    return buildString(json.length) {
        for (char in json) {
            if (char == '<' || char.isSurrogate()) append("\\u").append(char.code.toString(16).padStart(4, '0')) else append(char)
        }
    }
}
