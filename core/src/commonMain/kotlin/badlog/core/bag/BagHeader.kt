package badlog.core.bag

import badlog.core.json.JsonMember
import badlog.core.json.JsonReader
import badlog.core.json.JsonValue
import badlog.core.json.appendQuotedJson
import badlog.core.recording.Value

/**
 * The content of line 1 of a bag: its topics and its values. Unknown keys of the object itself, of a topic and of a
 * value are kept as JSON text, so that a header survives being read and written again.
 *
 * @property topics the topics, in the order of the line.
 * @property values the values, in the order of the line.
 * @property unknown unknown keys of the object, each with its value as JSON.
 */
public data class BagHeader(
    public val topics: List<BagTopic> = emptyList(),
    public val values: List<BagValue> = emptyList(),
    public val unknown: Map<String, String> = emptyMap(),
)

/**
 * A topic as line 1 of a bag describes it.
 *
 * @property name its full name, which is also its column's title on line 2.
 * @property unit its unit; `ul` means none.
 * @property attributes its attributes, in the order of the line.
 * @property unknown unknown keys, each with its value as JSON.
 */
public data class BagTopic(
    public val name: String,
    public val unit: String = "ul",
    public val attributes: List<String> = emptyList(),
    public val unknown: Map<String, String> = emptyMap(),
)

/**
 * A value in line 1 of a bag.
 *
 * @property value the name and the text that are shown.
 * @property unknown unknown keys, each with its value as JSON.
 */
public data class BagValue(public val value: Value, public val unknown: Map<String, String> = emptyMap())

/**
 * Reads line 1 of a bag. Missing keys are read as empty, and values of an unexpected type as their JSON text; of two equal
 * keys the last one counts.
 *
 * @return the header, or null if [line] is not exactly one JSON object.
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

/**
 * Returns line 1 of a bag without its newline: JSON in ASCII, apart from the names' own characters. A header that [readHeader] returned is
 * written with everything it had.
 *
 * A topic's name is written in the form that the line of titles can hold, so that both lines agree: a newline becomes a space; a
 * NUL, and half of a surrogate pair, become U+FFFD.
 *
 * It is written without a JSON library, because a robot writes it before its first loop and has only 256 MB of memory.
 *
 * @param asOriginal true to write the exact bytes that the original badlog wrote: a topic's unit comes before its name, and more
 *   characters are escaped than necessary.
 */
public fun headerText(header: BagHeader, asOriginal: Boolean = false): String = HeaderText(asOriginal).apply { append(header) }.toString()

private class HeaderText(private val asOriginal: Boolean) {
    private val out = StringBuilder()

    override fun toString() = out.toString()

    fun append(header: BagHeader) = jsonObject(header.unknown) {
        member("topics") { array(header.topics, ::append) }
        member("values") { array(header.values, ::append) }
    }

    private fun append(topic: BagTopic) = jsonObject(topic.unknown) {
        if (asOriginal) member("unit") { quoted(topic.unit) }
        member("name") { quoted(RowWriter.titleOf(topic.name)) }
        if (!asOriginal) member("unit") { quoted(topic.unit) }
        member("attrs") { array(topic.attributes, ::quoted) }
    }

    private fun append(value: BagValue) = jsonObject(value.unknown) {
        member("name") { quoted(value.value.name) }
        member("value") { quoted(value.value.text) }
    }

    private inline fun jsonObject(unknown: Map<String, String>, members: () -> Unit) {
        out.append('{')
        members()
        for ((key, json) in unknown) member(key) { out.append(json) }
        out.append('}')
    }

    private inline fun member(key: String, value: () -> Unit) {
        if (out.last() != '{') out.append(',')
        quoted(key)
        out.append(':')
        value()
    }

    private inline fun <T> array(items: List<T>, item: (T) -> Unit) {
        out.append('[')
        items.forEachIndexed { index, it ->
            if (index > 0) out.append(',')
            item(it)
        }
        out.append(']')
    }

    private fun quoted(text: String) {
        if (!asOriginal) {
            out.appendQuotedJson(text)
            return
        }
        out.append('"')
        for (char in text) escapedAsOriginal(char)
        out.append('"')
    }

    private fun escapedAsOriginal(char: Char) {
        val short = SHORT.indexOf(char)
        when {
            short >= 0 -> out.append('\\').append(SHORT_LETTERS[short])

            char < ' ' || char in '\u007f'..'\u009f' || char in '\u2000'..'\u20ff' ->
                out.append("\\u").append(char.code.toString(16).uppercase().padStart(4, '0'))

            else -> out.append(char)
        }
    }
}

private const val SHORT = "\"\\/\b\u000c\n\r\t"
private const val SHORT_LETTERS = "\"\\/bfnrt"
