package badlog.networktables.replay

import kotlinx.serialization.json.JsonObject

/**
 * The topics that one client publishes besides the recording's. The client gets the answers it expects; other clients do not see these
 * topics, and their values are dropped.
 *
 * @param firstId the lowest id that no topic of the recording has.
 */
internal class OwnTopics(firstId: Int) {
    private class Topic(val name: String, val id: Int, val type: String, val properties: JsonObject) {
        val publishers = HashSet<Long>()
    }

    private var nextId = firstId
    private val byName = HashMap<String, Topic>()
    private val byPublisher = HashMap<Long, Topic>()

    /** The number of publishers. */
    val size: Int get() = byPublisher.size

    fun publish(request: Request.Publish): JsonObject {
        val topic = byName.getOrPut(request.name) { Topic(request.name, nextId++, request.type, request.properties) }
        byPublisher.put(request.id, topic)?.publishers?.remove(request.id)
        topic.publishers += request.id
        return announce(topic.name, topic.id, topic.type, topic.properties, request.id)
    }

    /**
     * Removes a publisher, and returns the message that its topic is gone. Null if the topic has another publisher, or the publisher is
     * unknown.
     */
    fun unpublish(request: Request.Unpublish): JsonObject? {
        val topic = byPublisher.remove(request.id) ?: return null
        topic.publishers -= request.id
        if (topic.publishers.isNotEmpty()) return null
        byName.remove(topic.name, topic)
        return unannounce(topic.name, topic.id)
    }

    /** Returns the message that confirms new properties of a topic; null if the topic is not one of these. */
    fun setProperties(request: Request.SetProperties): JsonObject? =
        if (request.name in byName) acknowledge(request.name, request.update) else null
}
