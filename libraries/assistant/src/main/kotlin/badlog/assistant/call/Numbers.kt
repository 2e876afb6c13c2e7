package badlog.assistant.call

import badlog.core.analysis.Units
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonPrimitive

/** Returns [value] as JSON: without a fraction if it has none, and null if it is unknown or not finite. */
internal fun number(value: Double?): JsonElement = when {
    value == null || !value.isFinite() -> JsonNull
    value == Math.rint(value) && Math.abs(value) < MAX_WHOLE -> JsonPrimitive(value.toLong())
    else -> JsonPrimitive(value)
}

/** Returns [unit] as JSON; null for none. */
internal fun unitOf(unit: String): String? = unit.takeUnless(Units::isNone)

private const val MAX_WHOLE = 1e15
