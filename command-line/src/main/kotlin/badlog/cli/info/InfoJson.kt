package badlog.cli.info

import badlog.analysis.Units
import badlog.cli.text.json
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive

/** All about one log, for a program. */
internal fun infoJson(summary: LogSummary): Map<String, JsonElement> {
    val view = summary.view
    val recording = view.recording
    return mapOf(
        "format" to JsonPrimitive(recording.format.name.lowercase()),
        "bytes" to JsonPrimitive(summary.bytes),
        "match" to JsonPrimitive(view.title),
        "rows" to JsonPrimitive(recording.rowCount),
        "x" to JsonObject(
            mapOf(
                "name" to JsonPrimitive(view.xAxis.name),
                "topic" to JsonPrimitive(view.xAxis.topic?.name),
                "unit" to JsonPrimitive(unitOf(view.xAxis.unit)),
                "from" to json(summary.range?.start),
                "to" to json(summary.range?.endInclusive),
                "seconds" to json(summary.seconds),
            ),
        ),
        "values" to JsonArray(
            recording.values.map { JsonObject(mapOf("name" to JsonPrimitive(it.name), "text" to JsonPrimitive(it.text))) },
        ),
        "topics" to JsonArray(summary.topics.map(::topicJson)),
        "problems" to JsonArray(view.problems.map { json(it) }),
    )
}

private fun topicJson(summary: TopicSummary): JsonElement {
    val topic = summary.topic
    val counts = topic.counts
    return JsonObject(
        mapOf(
            "name" to JsonPrimitive(topic.name),
            "unit" to JsonPrimitive(unitOf(topic.unit)),
            "kind" to JsonPrimitive(topic.kind.name.lowercase()),
            "sparse" to JsonPrimitive(topic.isSparse),
            "attributes" to json(topic.attributes),
            "count" to JsonPrimitive(summary.count),
            "rate" to json(summary.rate),
            "min" to json(summary.min),
            "max" to json(summary.max),
            "texts" to JsonPrimitive(topic.texts.dictionary.size),
            "gaps" to JsonPrimitive(summary.gaps),
            "cells" to JsonObject(
                mapOf(
                    "numbers" to JsonPrimitive(counts.numbers),
                    "notFinite" to JsonPrimitive(counts.notFinite),
                    "truthValues" to JsonPrimitive(counts.truthValues),
                    "texts" to JsonPrimitive(counts.texts),
                    "empty" to JsonPrimitive(counts.empty),
                ),
            ),
        ),
    )
}

private fun unitOf(unit: String): String? = unit.takeUnless(Units::isNone)
