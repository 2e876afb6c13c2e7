package badlog.bag

import kotlinx.serialization.SerializationException
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive

internal actual fun parseJsonObject(text: String): List<JsonMember>? = try {
    (Json.parseToJsonElement(text) as? JsonObject)?.let(::membersOf)
} catch (_: SerializationException) {
    null
}

private fun membersOf(json: JsonObject): List<JsonMember> = json.map { (key, value) ->
    JsonMember(key, value.toString(), stringIn(value), (value as? JsonArray)?.map(::itemOf))
}

private fun itemOf(element: JsonElement) =
    JsonItem(stringIn(element) ?: element.toString(), (element as? JsonObject)?.let(::membersOf))

private fun stringIn(element: JsonElement): String? = (element as? JsonPrimitive)?.takeIf { it.isString }?.content
