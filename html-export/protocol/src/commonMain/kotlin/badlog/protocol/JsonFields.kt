package badlog.protocol

import badlog.core.json.JsonMember
import badlog.core.json.JsonValue

/** Thrown for text that the other side of the protocol never writes. */
internal class MalformedException : Exception()

internal fun malformed(): Nothing = throw MalformedException()

/** Returns the result of [read], or null if it finds something unexpected. */
internal fun <T> unlessMalformed(read: () -> T): T? = try {
    read()
} catch (_: MalformedException) {
    null
} catch (_: IndexOutOfBoundsException) {
    null
} catch (_: IllegalArgumentException) {
    null
}

/**
 * The members of a JSON object.
 *
 * @throws MalformedException if [members] is null because the value is not an object.
 */
class JsonFields(members: List<JsonMember>?) {
    private val values = (members ?: malformed()).associate { it.key to it.value }

    fun find(key: String): JsonValue? = values[key]

    operator fun get(key: String): JsonValue = values[key] ?: malformed()

    fun <T> list(key: String, read: (JsonValue) -> T): List<T> = (this[key].items ?: malformed()).map(read)
}

internal val JsonValue.string: String get() = text ?: malformed()

internal val JsonValue.number: Double get() = json.toDoubleOrNull() ?: malformed()

internal val JsonValue.boolean: Boolean get() = json.toBooleanStrictOrNull() ?: malformed()

/** Returns a JSON object of [members]; those with null instead of JSON are left out. */
fun jsonObject(vararg members: Pair<String, String?>): String =
    members.filter { it.second != null }.joinToString(",", "{", "}") { "\"${it.first}\":${it.second}" }

internal fun <T> array(items: List<T>, json: (T) -> String): String = items.joinToString(",", "[", "]", transform = json)

/**
 * Returns [json] in a form that is safe in a script element. Without any `<`, it can neither end the element nor begin a comment. UTF-8
 * cannot express half of a surrogate pair, so all surrogates are escaped.
 */
fun inScript(json: String): String {
    if (json.none { it == '<' || it.isSurrogate() }) return json
    return buildString(json.length) {
        for (char in json) {
            if (char == '<' || char.isSurrogate()) append("\\u").append(char.code.toString(16).padStart(4, '0')) else append(char)
        }
    }
}
