package badlog.bag

import badlog.recording.Value

/**
 * Reads line 1 of a bag. Keys that are missing read as nothing, keys of another type than expected as their JSON text.
 *
 * Each platform brings the JSON parser that costs least there: kotlinx-serialization on the JVM, the engine's own in
 * JavaScript, where the library would be two thirds of an exported page's script.
 *
 * @return the header, or null when [line] is not one whole JSON object.
 */
public fun readHeader(line: String): BagHeader? = parseJsonObject(line)?.let(::headerOf)

/** The JSON object that [text] is, member by member in order, or null when it is none. */
internal expect fun parseJsonObject(text: String): List<JsonMember>?

/**
 * One member of a JSON object.
 *
 * @property json the member's value as JSON text.
 * @property text the member's value where it is a string, else null.
 * @property items the items where the value is an array, else null.
 */
internal class JsonMember(
    val key: String,
    val json: String,
    val text: String?,
    val items: List<JsonItem>?,
)

/**
 * One item of a JSON array.
 *
 * @property text the string that it is, or the JSON text of anything else.
 * @property members the members where it is an object, else null.
 */
internal class JsonItem(val text: String, val members: List<JsonMember>?)

private fun headerOf(members: List<JsonMember>): BagHeader = BagHeader(
    topics = members.objects("topics").map(::topicOf),
    values = members.objects("values").map(::valueOf),
    unknown = members.without("topics", "values"),
)

private fun topicOf(members: List<JsonMember>) = BagTopic(
    name = members.text("name") ?: "",
    unit = members.text("unit") ?: "ul",
    attributes = members.find { it.key == "attrs" }?.items?.map { it.text } ?: emptyList(),
    unknown = members.without("name", "unit", "attrs"),
)

private fun valueOf(members: List<JsonMember>) = BagValue(
    value = Value(members.text("name") ?: "", members.text("value") ?: ""),
    unknown = members.without("name", "value"),
)

private fun List<JsonMember>.objects(key: String): List<List<JsonMember>> =
    find { it.key == key }?.items.orEmpty().mapNotNull { it.members }

private fun List<JsonMember>.text(key: String): String? =
    find { it.key == key }?.let { member -> if (member.json == "null") null else member.text ?: member.json }

private fun List<JsonMember>.without(vararg known: String): Map<String, String> =
    filter { it.key !in known }.associate { it.key to it.json }
