package badlog.bag

import badlog.json.JsonMember
import badlog.json.JsonReader
import badlog.json.JsonValue
import badlog.recording.Value

/**
 * Reads line 1 of a bag. Keys that are missing read as nothing, values of another type than expected as their JSON text; of
 * two equal keys the last counts.
 *
 * @return the header, or null when [line] is not one whole JSON object.
 */
public fun readHeader(line: String): BagHeader? = JsonReader.readObject(line)?.let(::headerOf)

private fun headerOf(members: List<JsonMember>): BagHeader = BagHeader(
    topics = members.objects("topics").map(::topicOf),
    values = members.objects("values").map(::valueOf),
    unknown = members.without("topics", "values"),
)

private fun topicOf(members: List<JsonMember>) = BagTopic(
    name = members.text("name") ?: "",
    unit = members.text("unit") ?: "ul",
    attributes = members.value("attrs")?.items.orEmpty().map { it.text ?: it.json },
    unknown = members.without("name", "unit", "attrs"),
)

private fun valueOf(members: List<JsonMember>) = BagValue(
    value = Value(members.text("name") ?: "", members.text("value") ?: ""),
    unknown = members.without("name", "value"),
)

private fun List<JsonMember>.value(key: String): JsonValue? = findLast { it.key == key }?.value

private fun List<JsonMember>.objects(key: String): List<List<JsonMember>> = value(key)?.items.orEmpty().mapNotNull { it.members }

private fun List<JsonMember>.text(key: String): String? = value(key)?.let { value -> value.text ?: value.json.takeIf { it != "null" } }

private fun List<JsonMember>.without(vararg known: String): Map<String, String> =
    filter { it.key !in known }.associate { it.key to it.value.json }
