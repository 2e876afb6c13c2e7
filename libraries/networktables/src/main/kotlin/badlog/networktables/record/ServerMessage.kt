package badlog.networktables.record

import badlog.networktables.UnreadableFrameException
import badlog.networktables.messagesIn
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.longOrNull

/** A server's message about its topics. */
internal sealed interface ServerMessage {
    /**
     * The topic [name] exists, and its values are sent with [id].
     *
     * @property type its type, such as `double` or `struct:Pose2d`.
     */
    class Announce(val name: String, val id: Long, val type: String, val properties: JsonObject) : ServerMessage

    /** The topic [name] no longer exists. */
    class Unannounce(val name: String, val id: Long) : ServerMessage

    /** The properties of the topic [name] are changed to those in [update]; a null in it removes a property. */
    class Properties(val name: String, val update: JsonObject) : ServerMessage
}

/** Returns the messages in the text frame [text]. Unknown content is skipped and passed to [ignore], as part of a sentence. */
internal fun serverMessages(text: String, ignore: (String) -> Unit): List<ServerMessage> = try {
    messagesIn(text).mapNotNull { message ->
        val method = (message as? JsonObject)?.get("method").text()
        val params = (message as? JsonObject)?.get("params") as? JsonObject
        // Later versions of the protocol may have more methods.
        if (method !in METHODS) return@mapNotNull null
        (params?.let { read(method, it) }).also { if (it == null) ignore("an incomplete “$method”") }
    }
} catch (e: UnreadableFrameException) {
    ignore(e.what)
    emptyList()
}

private fun read(method: String?, params: JsonObject): ServerMessage? {
    val name = params["name"].text() ?: return null
    val id = (params["id"] as? JsonPrimitive)?.takeIf { !it.isString }?.longOrNull
    return when (method) {
        "announce" -> {
            val type = params["type"].text()
            val properties = params["properties"] as? JsonObject ?: JsonObject(emptyMap())
            if (id == null || type == null) null else ServerMessage.Announce(name, id, type, properties)
        }

        "unannounce" -> id?.let { ServerMessage.Unannounce(name, it) }

        else -> (params["update"] as? JsonObject)?.let { ServerMessage.Properties(name, it) }
    }
}

private fun JsonElement?.text() = (this as? JsonPrimitive)?.takeIf { it.isString }?.content

private val METHODS = listOf("announce", "unannounce", "properties")
