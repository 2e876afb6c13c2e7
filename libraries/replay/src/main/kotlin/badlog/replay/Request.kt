package badlog.replay

import kotlinx.serialization.json.JsonObject

/** What a client asks for. */
internal sealed interface Request {
    /**
     * @property names whole names, or how names begin where [isPrefix].
     * @property periodMicros how often a value may be sent at most.
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
