package badlog.networktables.replay

import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonObjectBuilder
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put

/** Returns the properties of a recording's topic. It is marked as retained, because it exists as long as the server. */
internal fun propertiesOf(signal: ReplayedTopic): JsonObject = buildJsonObject {
    signal.unit?.let { put("unit", it) }
    put("retained", true)
}

/** Returns the message that the topic [name] has the id [id]; in an answer to a publisher, with the publisher's id. */
internal fun announce(name: String, id: Int, type: String, properties: JsonObject, publisher: Long? = null): JsonObject =
    message("announce") {
        put("name", name)
        put("id", id)
        put("type", type)
        publisher?.let { put("pubuid", it) }
        put("properties", properties)
    }

/** Returns the message that the topic [name] no longer exists. */
internal fun unannounce(name: String, id: Int): JsonObject = message("unannounce") {
    put("name", name)
    put("id", id)
}

/** Returns the message to a client that the properties of its topic have changed. */
internal fun acknowledge(name: String, update: JsonObject): JsonObject = message("properties") {
    put("name", name)
    put("ack", true)
    put("update", update)
}

private fun message(method: String, params: JsonObjectBuilder.() -> Unit) = buildJsonObject {
    put("method", method)
    put("params", buildJsonObject(params))
}

/** Returns [messages] as text frames of limited length, each a JSON list. */
internal fun textFrames(messages: List<JsonObject>): List<String> {
    val frames = ArrayList<String>()
    val frame = StringBuilder()
    for (message in messages) {
        frame.append(if (frame.isEmpty()) '[' else ',').append(message)
        if (frame.length >= FULL_LENGTH) {
            frames += frame.append(']').toString()
            frame.clear()
        }
    }
    if (frame.isNotEmpty()) frames += frame.append(']').toString()
    return frames
}

private const val FULL_LENGTH = 8192
