package badlog.season.sql

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import org.duckdb.DuckDBStruct
import java.sql.Blob
import java.sql.Timestamp
import java.time.Instant
import java.time.LocalDateTime
import java.time.OffsetDateTime
import java.time.ZoneOffset
import java.time.format.DateTimeFormatter

/** Returns a DuckDB value as JSON: times are texts, and so are numbers that JSON cannot express. */
internal fun jsonOf(value: Any?): JsonElement = when (value) {
    null -> JsonNull
    is Boolean -> JsonPrimitive(value)
    is Double -> if (value.isFinite()) JsonPrimitive(value) else JsonPrimitive("$value")
    is Float -> jsonOf(value.toDouble())
    is Number -> JsonPrimitive(value)
    is OffsetDateTime -> JsonPrimitive(DateTimeFormatter.ISO_INSTANT.format(value.withOffsetSameInstant(ZoneOffset.UTC)))
    is Instant -> JsonPrimitive("$value")
    is Timestamp -> JsonPrimitive("${value.toLocalDateTime()}")
    is LocalDateTime -> JsonPrimitive("$value")
    is java.sql.Array -> JsonArray((value.array as Array<*>).map(::jsonOf))
    is DuckDBStruct -> JsonObject(value.map.mapValues { jsonOf(it.value) })
    is Map<*, *> -> JsonObject(value.entries.associate { (key, held) -> "$key" to jsonOf(held) })
    is List<*> -> JsonArray(value.map(::jsonOf))
    is Blob -> JsonPrimitive("(${value.length()} bytes)")
    else -> JsonPrimitive("$value")
}
