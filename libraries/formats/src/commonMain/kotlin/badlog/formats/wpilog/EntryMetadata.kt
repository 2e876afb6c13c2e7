package badlog.formats.wpilog

import badlog.core.analysis.Units
import badlog.core.json.JsonMember
import badlog.core.json.JsonReader
import badlog.core.json.JsonValue
import badlog.core.json.quotedJson
import badlog.core.recording.Topic
import badlog.core.recording.TopicKind

/** The metadata that marks an entry as a value. */
internal const val VALUE_METADATA: String = "{\"badlog\":\"value\"}"

/** The role of a topic that was the x axis of a bag, as named in an entry's metadata. */
internal const val X_AXIS: String = "xaxis"

/** The role of a topic that had few samples in a bag. */
internal const val SPARSE: String = "sparse"

/** Returns the topic's role in a bag according to [metadata]; usually null. A program's property of the same name has no effect. */
internal fun formerRoleIn(metadata: String): String? = JsonReader.readObject(metadata).orEmpty().last(BADLOG)?.text

/** Returns the former type of a topic if [role] names it; otherwise null. */
internal fun formerTypeIn(role: String?): String? = role?.takeIf { it.startsWith(TYPE_ROLE) }?.substring(TYPE_ROLE.length)

private fun roleOf(topic: Topic, type: String): String? = when {
    X_AXIS in topic.attributes -> X_AXIS
    topic.isSparse && (topic.kind == TopicKind.NUMERIC || topic.kind == TopicKind.BOOLEAN) -> SPARSE
    topic.type != type && (topic.isSizes || PARTED.any { topic.type.startsWith(it) }) -> TYPE_ROLE + topic.type
    else -> null
}

/** Returns the unit in [metadata]: beside a logger's own remarks, or in the properties of a NetworkTables topic. */
internal fun unitIn(metadata: String): String {
    val members = JsonReader.readObject(metadata).orEmpty()
    return (members.last(UNIT) ?: members.property(UNIT))?.text ?: Topic.UNITLESS
}

/**
 * Returns the attributes of the entry [name]. They come from its [metadata], if badlog wrote them, or from the properties of a
 * NetworkTables topic, which a robot's program sets; entries that WPILib itself writes have known attributes.
 */
internal fun attributesIn(metadata: String, name: String): List<String> {
    val members = JsonReader.readObject(metadata).orEmpty()
    val own = members.last(ATTRIBUTES)?.items ?: members.property(BADLOG)?.run { items ?: listOf(this) }
    return own?.mapNotNull { it.text } ?: when {
        name in MESSAGES || CONSOLE in name -> listOf(LOG)
        name == Entry.SYSTEM_TIME || Entry.SCHEMA_FOLDER in name || name.endsWith(TYPE) -> listOf("hide")
        else -> emptyList()
    }
}

private fun List<JsonMember>.last(key: String): JsonValue? = findLast { it.key == key }?.value

private fun List<JsonMember>.property(key: String): JsonValue? = last("properties")?.members?.last(key)

/**
 * Returns the original metadata of [topic] if they contain its unit and all attributes; otherwise JSON that does.
 *
 * @param type the type of the entry to which it is written.
 */
internal fun metadataOf(topic: Topic, type: String = topic.type): String {
    val attributes = attributesOf(topic)
    val role = roleOf(topic, type)
    val unit = unitIn(topic.metadata)
    val isSameUnit = unit == topic.unit || (Units.isNone(unit) && Units.isNone(topic.unit))
    if (role == null && isSameUnit && attributesIn(topic.metadata, topic.name) == attributes) return topic.metadata
    val own = JsonReader.readObject(topic.metadata)
    val members = ArrayList<String>()
    val rewritten = listOfNotNull(UNIT, ATTRIBUTES, BADLOG.takeIf { role != null })
    for (member in own.orEmpty()) {
        if (member.key !in rewritten) members += quotedJson(member.key) + ":" + member.value.json
    }
    if (own == null && topic.metadata.isNotEmpty()) members += "\"metadata\":" + quotedJson(topic.metadata)
    if (role != null) members += quotedJson(BADLOG) + ":" + quotedJson(role)
    if (!Units.isNone(topic.unit)) members += "\"unit\":" + quotedJson(topic.unit)
    val others = if (members.isEmpty()) "" else members.joinToString(",", "{", "}")
    // An empty list, too, if there would be other ones without it.
    if (attributes != attributesIn(others, topic.name)) {
        members += "\"attrs\":" + attributes.joinToString(",", "[", "]", transform = ::quotedJson)
    }
    return if (members.isEmpty()) "" else members.joinToString(",", "{", "}")
}

private fun attributesOf(topic: Topic): List<String> {
    // The times of the records replace an x axis.
    val attributes = topic.attributes - X_AXIS
    // In a bag, empty cells show that texts are events; they have no records here.
    val isEvent = topic.times == null && topic.kind == TopicKind.EVENT && LOG !in attributes
    return if (isEvent) attributes + LOG else attributes
}

/** The entries to which WPILib's logger writes the program's messages, and since 2024 all of its output. */
private val MESSAGES = setOf("messages", "console")

/** The folder in which the Driver Station of 2027 writes its messages, and the robot's errors. */
private const val CONSOLE = "DS:/Dscomm/Console/"

/** The entry in which dashboards, and Telemetry from 2027 on, name the type of the topics beside it: `Field2d`. */
private const val TYPE = "/.type"
private const val UNIT = "unit"
private const val ATTRIBUTES = "attrs"

/** The property of a NetworkTables topic in which a program sets attributes; and badlog's own mark beside the properties. */
private const val BADLOG = "badlog"

/** The attribute of texts that are events. */
internal const val LOG: String = "log"

/** The beginning of the role of a topic that was part of a type, or the size of its bytes. */
private const val TYPE_ROLE = "type "

/** The beginnings of types with parts that are topics. */
private val PARTED = listOf("struct:", "proto:")
