package badlog.report

import badlog.expression.Figure
import badlog.plot.Span
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonObjectBuilder
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.addJsonObject
import kotlinx.serialization.json.buildJsonArray
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put

internal val PRETTY = Json { prettyPrint = true }

/** [results] as one JSON object for other programs: all files, also those in which nothing was found. Unknown numbers are null. */
public fun findJson(question: String, results: List<FindResult>): String = PRETTY.encodeToString(
    JsonObject.serializer(),
    buildJsonObject {
        put("question", question)
        put("results", JsonArray(results.map(::resultJson)))
    },
)

private fun resultJson(result: FindResult): JsonElement = buildJsonObject {
    put("file", result.file.path.toString())
    put("match", result.title)
    if (result.undefined.isNotEmpty()) put("undefined", undefinedJson(result.undefined))
    when (val reply = result.reply) {
        is Reply.Answered -> {
            put("outcome", reply.outcome.name.lowercase())
            put("time", number(reply.time))
            put("timeUnit", reply.timeUnit)
            put("figures", buildJsonArray { reply.figures.forEach { addJsonObject { putFigure(it) } } })
            put("spans", spansJson(reply.spans))
            put("spanCount", reply.spanCount)
        }
        is Reply.NotAsked -> {
            put("outcome", "not_asked")
            put("reason", reply.kind.name.lowercase())
            put("topic", reply.topic)
            put("message", reply.message)
        }
        is Reply.Unreadable -> {
            put("outcome", "unreadable")
            put("message", reply.message)
        }
    }
}

private fun JsonObjectBuilder.putFigure(figure: Figure) {
    put("name", figure.name)
    put("value", number(figure.value))
    put("unit", figure.unit)
    put("time", number(figure.time))
}

internal fun spansJson(spans: List<Span>): JsonArray = buildJsonArray {
    for (span in spans) {
        addJsonObject {
            put("from", number(span.from))
            put("to", number(span.to))
        }
    }
}

internal fun undefinedJson(topics: List<UndefinedTopic>): JsonArray = buildJsonArray {
    for (topic in topics) {
        addJsonObject {
            put("definition", topic.definition)
            put("message", topic.message)
        }
    }
}

/** JSON has no number for what is not finite. */
internal fun number(value: Double): JsonPrimitive = if (value.isFinite()) JsonPrimitive(value) else JsonNull
