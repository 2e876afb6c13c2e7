package badlog.networktables.replay

import badlog.networktables.UnreadableFrameException
import badlog.networktables.messagesIn
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.booleanOrNull
import kotlinx.serialization.json.doubleOrNull
import kotlinx.serialization.json.longOrNull

/** Reads a client's text frames. Unknown content is skipped and passed to [ignore], as part of a sentence. */
internal class RequestReader(private val ignore: (String) -> Unit) {
    fun read(text: String): List<Request> {
        val messages = try {
            messagesIn(text)
        } catch (e: UnreadableFrameException) {
            return noRequests(e.what)
        }
        return messages.mapNotNull(::request)
    }

    private fun request(message: JsonElement): Request? {
        val method = (message as? JsonObject)?.get("method").text()
        val params = (message as? JsonObject)?.get("params") as? JsonObject
        if (method == null || params == null) return refuse("a message without a method or its parameters")
        return when (method) {
            "subscribe" -> subscribe(params)

            "unsubscribe" -> params["subuid"].number()?.let(Request::Unsubscribe)

            "publish" -> publish(params)

            "unpublish" -> params["pubuid"].number()?.let(Request::Unpublish)

            "setproperties" -> {
                val name = params["name"].text()
                val update = params["update"] as? JsonObject
                if (name == null || update == null) null else Request.SetProperties(name, update)
            }

            else -> return refuse("an unknown method")
        } ?: refuse("an incomplete “$method”")
    }

    private fun subscribe(params: JsonObject): Request? {
        val id = params["subuid"].number() ?: return null
        val names = (params["topics"] as? JsonArray)?.map { it.text() ?: return null } ?: return null
        val options = params["options"] as? JsonObject ?: JsonObject(emptyMap())
        val seconds = (options["periodic"] as? JsonPrimitive)?.doubleOrNull?.takeIf { it >= 0 } ?: DEFAULT_SECONDS
        fun isSet(option: String) = (options[option] as? JsonPrimitive)?.booleanOrNull == true
        return Request.Subscribe(
            id,
            names,
            (seconds * 1e6).toLong(),
            isSet("all"),
            isSet("topicsonly"),
            isSet("prefix"),
        )
    }

    private fun publish(params: JsonObject): Request? {
        val id = params["pubuid"].number() ?: return null
        val name = params["name"].text() ?: return null
        val type = params["type"].text() ?: return null
        return Request.Publish(id, name, type, params["properties"] as? JsonObject ?: JsonObject(emptyMap()))
    }

    private fun JsonElement?.text() = (this as? JsonPrimitive)?.takeIf { it.isString }?.content

    private fun JsonElement?.number() = (this as? JsonPrimitive)?.takeIf { !it.isString }?.longOrNull

    private fun noRequests(why: String): List<Request> = emptyList<Request>().also { ignore(why) }

    private fun refuse(why: String): Request? = null.also { ignore(why) }
}

/** A request of a client. */
internal sealed interface Request {
    /**
     * A request for the values of topics.
     *
     * @property names full names, or prefixes of names if [isPrefix].
     * @property periodMicros the minimum time between values.
     * @property isAll whether every sample is wanted, not only the latest of each period.
     * @property isTopicsOnly whether no values are wanted.
     */
    class Subscribe(
        val id: Long,
        val names: List<String>,
        val periodMicros: Long,
        val isAll: Boolean,
        val isTopicsOnly: Boolean,
        val isPrefix: Boolean,
    ) : Request

    class Unsubscribe(val id: Long) : Request

    class Publish(val id: Long, val name: String, val type: String, val properties: JsonObject) : Request

    class Unpublish(val id: Long) : Request

    class SetProperties(val name: String, val update: JsonObject) : Request
}

/** The default period of a client's values, in s. */
private const val DEFAULT_SECONDS = 0.1
