package badlog.report

import badlog.analysis.Span
import badlog.expression.ExpressionError
import badlog.expression.Quantity
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.addJsonObject
import kotlinx.serialization.json.buildJsonArray
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put

/** What came of a question to a log that can be read, for other programs. Of what is not known, and of unknown numbers, null is told. */
public fun findJson(result: FindResult): Map<String, JsonElement> = buildJsonObject {
    val answered = result.reply as? Reply.Answered
    val refused = result.reply as? Reply.NotAsked
    put("match", result.title)
    put("outcome", answered?.outcome?.name?.lowercase() ?: "not_asked")
    put("time", number(answered?.time))
    put("timeUnit", answered?.timeUnit)
    put("figures", JsonArray(answered?.figures.orEmpty().map(::figureJson)))
    put("spans", spansJson(answered?.spans.orEmpty()))
    put("spanCount", answered?.spanCount)
    put("reason", refused?.kind?.name?.lowercase())
    put("topic", refused?.topic)
    put("message", refused?.message)
    put("undefined", jsonOf(result.undefined))
}

private fun figureJson(figure: Quantity): JsonElement = buildJsonObject {
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

/** The virtual topics that a log could not be given, by the [errors] in their definitions, for other programs. */
public fun undefinedJson(errors: List<ExpressionError>): JsonElement = jsonOf(errors.map(::UndefinedTopic))

internal fun jsonOf(topics: List<UndefinedTopic>): JsonArray = buildJsonArray {
    for (topic in topics) {
        addJsonObject {
            put("definition", topic.definition)
            put("message", topic.message)
        }
    }
}

/** JSON has no number for what is not finite. */
internal fun number(value: Double?): JsonPrimitive = if (value != null && value.isFinite()) JsonPrimitive(value) else JsonNull
