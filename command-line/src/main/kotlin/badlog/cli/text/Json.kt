package badlog.cli.text

import badlog.recording.Loss
import badlog.recording.Problem
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive

/** [number] as JSON, which has neither NaN nor infinities: null. Whole numbers are written as such. */
internal fun json(number: Double?): JsonElement = when {
    number == null || !number.isFinite() -> JsonNull
    number == Math.rint(number) && Math.abs(number) < WHOLE -> JsonPrimitive(number.toLong())
    else -> JsonPrimitive(number)
}

/** Each of [texts] as JSON. */
internal fun json(texts: List<String>): JsonElement = JsonArray(texts.map(::JsonPrimitive))

/** [problem] as JSON, the same for every sub-command. */
internal fun json(problem: Problem): JsonElement = JsonObject(
    mapOf(
        "kind" to JsonPrimitive(problem.kind.name),
        "severity" to JsonPrimitive(problem.severity.name.lowercase()),
        "message" to JsonPrimitive(problem.message),
        "line" to JsonPrimitive(problem.line),
        "topic" to JsonPrimitive(problem.topic),
        "count" to JsonPrimitive(problem.count),
        "lost" to json(problem.loss),
    ),
)

/** [loss] as JSON. */
internal fun json(loss: Loss): JsonElement = JsonObject(
    mapOf("rows" to JsonPrimitive(loss.rows), "cells" to JsonPrimitive(loss.cells), "bytes" to JsonPrimitive(loss.bytes)),
)

private const val WHOLE = 1e15
