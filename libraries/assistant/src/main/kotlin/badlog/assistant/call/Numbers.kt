package badlog.assistant.call

import badlog.analysis.Units
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonPrimitive

/** [value] in JSON: without a fraction where it has none, and null where it is not known or not finite. */
internal fun number(value: Double?): JsonElement = when {
    value == null || !value.isFinite() -> JsonNull
    value == Math.rint(value) && Math.abs(value) < MAX_WHOLE -> JsonPrimitive(value.toLong())
    else -> JsonPrimitive(value)
}

/** [unit] in JSON; null for none. */
internal fun unitOf(unit: String): String? = unit.takeUnless(Units::isNone)

private const val MAX_WHOLE = 1e15
