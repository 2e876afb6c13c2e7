package badlog.signals.vocabulary

import badlog.core.json.JsonValue
import badlog.core.json.quotedJson
import badlog.signals.json.JsonFields
import badlog.signals.json.UnreadableJsonException
import badlog.signals.json.itemsOf
import badlog.signals.json.jsonArray
import badlog.signals.json.jsonList
import badlog.signals.json.jsonObject
import badlog.signals.json.stringOf

/** Returns this vocabulary as a line of JSON. Equal texts mean equal vocabularies. */
fun SignalVocabulary.toJson(): String = jsonObject(
    "signals" to jsonArray(signals, ::signalJson),
    "units" to jsonList(units) { "[${quotedJson(it.ending)},${quotedJson(it.unit)}]" },
    "linked" to jsonList(linked) { checkNotNull(patternsJson(it)) },
)

/** Returns the vocabulary in [value], or null if [SignalVocabulary.toJson] did not write it. */
fun SignalVocabulary.Companion.fromJson(value: JsonValue): SignalVocabulary? = try {
    val json = JsonFields(value.members)
    SignalVocabulary(
        json.list("signals", ::signalOf),
        json.list("units") { pair -> itemsOf(pair).let { (ending, unit) -> NamedUnit(stringOf(ending), stringOf(unit)) } },
        json.list("linked") { devices -> itemsOf(devices).map { NamePattern(stringOf(it)) } },
    )
} catch (_: UnreadableJsonException) {
    null
} catch (_: IndexOutOfBoundsException) {
    null
}

/** Returns [patterns] as a JSON array of texts; null if there are none. */
fun patternsJson(patterns: List<NamePattern>): String? = jsonList(patterns) { quotedJson(it.text) }

fun JsonFields.patterns(key: String): List<NamePattern> = strings(key).map(::NamePattern)

private fun signalJson(signal: SignalName): String = jsonObject(
    "name" to quotedJson(signal.name),
    "is" to signal.content.takeIf { it != SignalContent.NUMBER }?.let { quotedJson(it.name.lowercase()) },
    "unit" to signal.unit?.let(::quotedJson),
    "topics" to jsonArray(signal.topics) { topic ->
        val name = quotedJson(topic.pattern.text)
        if (topic.unit == null) name else "[$name,${quotedJson(topic.unit)}]"
    },
    "except" to patternsJson(signal.except),
    "many" to "true".takeIf { signal.isMany },
    "sumOf" to signal.sumOf?.let(::quotedJson),
    "atMost" to signal.atMost?.let { quotedJson(it.toString()) },
)

private fun signalOf(value: JsonValue): SignalName {
    val json = JsonFields(value.members)
    return SignalName(
        name = json.string("name"),
        meaning = "",
        content = SignalContent.entries.find { it.name.lowercase() == json.optional("is") } ?: SignalContent.NUMBER,
        unit = json.optional("unit"),
        topics = json.list("topics") { topic ->
            val pair = topic.items
            if (pair == null) {
                TopicPattern(NamePattern(stringOf(topic)), null)
            } else {
                TopicPattern(NamePattern(stringOf(pair[0])), stringOf(pair[1]))
            }
        },
        except = json.patterns("except"),
        isMany = json.isTrue("many"),
        sumOf = json.optional("sumOf"),
        atMost = json.optional("atMost")?.toDouble(),
    )
}
