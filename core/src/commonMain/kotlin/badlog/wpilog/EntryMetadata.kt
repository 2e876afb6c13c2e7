package badlog.wpilog

import badlog.analysis.Units
import badlog.bag.JsonReader
import badlog.bag.quotedJson
import badlog.recording.Topic

/** The metadata by which an entry becomes a value again. */
internal const val VALUE_METADATA: String = "{\"badlog\":\"value\"}"

/** What the metadata of [topic] say once more, with its unit and attributes, as JSON; empty when there is nothing to say. */
internal fun metadataOf(topic: Topic): String {
    val own = JsonReader.readObject(topic.metadata)
    val members = ArrayList<String>()
    for (member in own.orEmpty()) {
        if (member.key != "unit" && member.key != "attrs") members += quotedJson(member.key) + ":" + member.value.json
    }
    if (own == null && topic.metadata.isNotEmpty()) members += "\"metadata\":" + quotedJson(topic.metadata)
    if (!Units.isNone(topic.unit)) members += "\"unit\":" + quotedJson(topic.unit)
    // The times of the records take the place of an x axis.
    val attributes = topic.attributes - "xaxis"
    if (attributes.isNotEmpty()) members += "\"attrs\":" + attributes.joinToString(",", "[", "]", transform = ::quotedJson)
    return if (members.isEmpty()) "" else members.joinToString(",", "{", "}")
}
