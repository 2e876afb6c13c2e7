package badlog.formats.conformance

import badlog.core.json.quotedJson
import badlog.core.recording.Problem
import badlog.core.recording.Recording
import badlog.core.recording.Topic

/** Returns everything that [recording] holds as JSON, which readers in other languages must find in the same bytes, too. */
internal fun logJson(recording: Recording): String = buildString {
    append("{\n\"format\":").append(quotedJson(recording.format.id))
    append(",\n\"values\":").append(list(recording.values) { "[${quotedJson(it.name)},${quotedJson(it.text)}]" })
    append(",\n\"topics\":").append(list(recording.topics, "\n", ::topicJson))
    append(",\n\"problems\":").append(list(recording.problems, "\n", ::problemJson))
    append("\n}\n")
}

private fun topicJson(topic: Topic): String {
    val counts = topic.counts.run { listOf(numbers, notFinite, truthValues, texts, empty, gaps) }
    return listOf(
        "name" to quotedJson(topic.name),
        "unit" to quotedJson(topic.unit),
        "attributes" to list(topic.attributes, transform = ::quotedJson),
        "kind" to quotedJson(topic.kind.name.lowercase()),
        "type" to quotedJson(topic.type),
        "metadata" to quotedJson(topic.metadata),
        "counts" to list(counts) { it.toString() },
        "times" to list(topic.times.orEmpty().asList(), transform = ::numberJson),
        "samples" to list(topic.samples.asList(), transform = ::numberJson),
        "texts" to list(List(topic.texts.size) { it }) { "[${topic.texts.rows[it]},${quotedJson(topic.texts[it])}]" },
    ).joinToString(",", "{", "}") { (key, json) -> "\"$key\":$json" }
}

private fun problemJson(problem: Problem): String = "{\"kind\":\"${problem.kind}\",\"topic\":${problem.topic?.let(::quotedJson)},\"count\":${problem.count},\"message\":${quotedJson(problem.message)}}"

private fun DoubleArray?.orEmpty(): DoubleArray = this ?: DoubleArray(0)

private fun numberJson(number: Double): String = if (number.isFinite()) number.toString() else "\"$number\""

private fun <T> list(items: List<T>, separator: String = "", transform: (T) -> String): String = items.joinToString(",$separator", "[$separator", "]", transform = transform)
