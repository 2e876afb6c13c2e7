package badlog.season.lake

import badlog.core.recording.Topic
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive

/**
 * Returns the description of [topics] for the metadata of a file of samples, as JSON. It has the unit and attributes of each topic, under
 * the name of its column, or its own name if it has no column.
 */
internal fun topicsJson(topics: List<Topic>, columnOf: Map<Topic, String>, identity: LogIdentity): String = JsonObject(
    mapOf(
        "version" to JsonPrimitive(LakeLayout.VERSION),
        "title" to JsonPrimitive(identity.match.title),
        "columns" to JsonObject(
            topics.associate { topic ->
                val fields = mapOf(
                    "topic" to JsonPrimitive(topic.name),
                    "unit" to JsonPrimitive(unitOf(topic)),
                    "attributes" to JsonArray(topic.attributes.map(::JsonPrimitive)),
                )
                (columnOf[topic] ?: topic.name) to JsonObject(fields)
            },
        ),
    ),
).toString()
