package badlog.report.hook

import badlog.core.analysis.Series
import badlog.core.recording.Severity
import kotlinx.serialization.SerializationException
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.doubleOrNull
import java.util.Base64

/** Reads and checks the output of a hook. Throws [IllegalArgumentException] with a sentence at the first invalid part. */
internal object HookOutput {
    fun read(text: String): HookResult {
        require(text.isNotBlank()) { "The hook printed nothing; it must print one JSON object, at least {}." }
        requireShallow(text)
        val root = try {
            Json.parseToJsonElement(text)
        } catch (e: SerializationException) {
            throw IllegalArgumentException("The hook did not print JSON: ${e.message.orEmpty().lineSequence().first().take(MAX_QUOTED)}.")
        }
        val members = membersOf(root, "the output", setOf("values", "findings", "series", "figures"))
        return HookResult(
            values = (members["values"] ?: JsonObject(emptyMap())).let(::values),
            findings = items(members, "findings", MAX_FINDINGS, ::finding),
            series = items(members, "series", MAX_SERIES, ::series),
            figures = items(members, "figures", MAX_FIGURES, ::figure),
        )
    }

    /** Valid results are not nested more deeply, and deeper ones could overflow the stack. */
    private fun requireShallow(text: String) {
        var depth = 0
        var isInText = false
        var at = 0
        while (at < text.length) {
            when (text[at]) {
                '"' -> isInText = !isInText
                '\\' -> at++
                '[', '{' -> if (!isInText) require(++depth <= MAX_DEPTH) { "The hook's output is nested too deeply." }
                ']', '}' -> if (!isInText) depth--
            }
            at++
        }
    }

    private fun values(json: JsonElement): Map<String, String> {
        require(json is JsonObject) { "“values” must be an object of texts and numbers, not ${kindOf(json)}." }
        require(json.size <= MAX_VALUES) { "There are ${json.size} values; at most $MAX_VALUES are allowed." }
        return json.mapValues { (name, value) ->
            require(value is JsonPrimitive && value !is JsonNull) {
                "The value “${name.take(MAX_NAME)}” must be a text or a number, not ${kindOf(value)}."
            }
            limited(value.content, MAX_TEXT, "The value “${name.take(MAX_NAME)}”")
        }
    }

    private fun finding(json: JsonElement, where: String): HookFinding {
        val members = membersOf(json, where, setOf("severity", "text", "time", "until"))
        val severity = text(members, "severity", where, MAX_NAME, "warning")
        val time = numberIn(members, "time", where)
        val until = numberIn(members, "until", where)
        require(until.isNaN() || until >= time) { "In $where “until” must not be before “time”." }
        return HookFinding(
            Severity.entries.find { it.name.lowercase() == severity }
                ?: throw IllegalArgumentException("In $where “severity” must be error, warning or note, not “$severity”."),
            text(members, "text", where, MAX_TEXT),
            time,
            until,
        )
    }

    private fun series(json: JsonElement, where: String): HookSeries {
        val members = membersOf(json, where, setOf("name", "unit", "x", "y"))
        val x = numbers(members, "x", where, areGapsAllowed = false)
        val y = numbers(members, "y", where, areGapsAllowed = true)
        require(x.size == y.size) { "In $where “x” has ${x.size} numbers and “y” has ${y.size}; they must have the same length." }
        for (i in 1 until x.size) require(x[i] >= x[i - 1]) { "In $where “x” decreases at number ${i + 1}; sort it." }
        return HookSeries(text(members, "name", where, MAX_NAME), text(members, "unit", where, MAX_NAME, ""), Series(x, y))
    }

    private fun figure(json: JsonElement, where: String): HookFigure {
        val members = membersOf(json, where, setOf("title", "svg", "png"))
        val title = text(members, "title", where, MAX_NAME)
        require(("svg" in members) != ("png" in members)) { "In $where either “svg” or “png” is needed." }
        if ("svg" in members) {
            val svg = text(members, "svg", where, MAX_FIGURE)
            require(beginsAsSvg(svg)) { "In $where “svg” must be an SVG picture that starts with <svg." }
            return HookFigure(title, "image/svg+xml", picture(svg.encodeToByteArray(), "In $where “svg”"))
        }
        val png = try {
            Base64.getMimeDecoder().decode(text(members, "png", where, MAX_BASE64))
        } catch (_: IllegalArgumentException) {
            throw IllegalArgumentException("In $where “png” must be Base64.")
        }
        require(png.size > PNG.size && PNG.indices.all { png[it] == PNG[it] }) { "In $where “png” must be a PNG picture in Base64." }
        return HookFigure(title, "image/png", picture(png, "In $where “png”"))
    }

    private fun picture(bytes: ByteArray, what: String): ByteArray {
        require(bytes.size <= MAX_FIGURE) { "$what has ${bytes.size} bytes; at most $MAX_FIGURE are allowed." }
        return bytes
    }

    private fun <T> items(members: JsonObject, key: String, most: Int, read: (JsonElement, String) -> T): List<T> {
        val json = members[key] ?: return emptyList()
        require(json is JsonArray) { "“$key” must be a list, not ${kindOf(json)}." }
        require(json.size <= most) { "There are ${json.size} $key; at most $most are allowed." }
        return json.mapIndexed { index, item -> read(item, "number ${index + 1} of “$key”") }
    }

    private fun membersOf(json: JsonElement, where: String, known: Set<String>): JsonObject {
        require(json is JsonObject) { "The hook's output is wrong: $where is ${kindOf(json)}, not an object." }
        val unknown = json.keys.firstOrNull { it !in known } ?: return json
        throw IllegalArgumentException("In $where “${unknown.take(MAX_NAME)}” is not a key; the keys are ${known.joinToString()}.")
    }

    private fun text(members: JsonObject, key: String, where: String, most: Int, absent: String? = null): String {
        val json = members[key] ?: absent?.let { return it } ?: throw IllegalArgumentException("In $where “$key” is missing.")
        require(json is JsonPrimitive && json.isString) { "In $where “$key” must be a text, not ${kindOf(json)}." }
        return limited(json.content, most, "In $where “$key”")
    }

    private fun limited(text: String, most: Int, what: String): String {
        require(text.length <= most) { "$what has ${text.length} characters; at most $most are allowed." }
        return text
    }

    private fun numberIn(members: JsonObject, key: String, where: String): Double {
        val json = members[key] ?: return Double.NaN
        return number(json) ?: throw IllegalArgumentException("In $where “$key” must be a number or missing, not ${kindOf(json)}.")
    }

    private fun number(json: JsonElement): Double? =
        (json as? JsonPrimitive)?.takeIf { !it.isString }?.doubleOrNull?.takeIf { it.isFinite() }

    private fun numbers(members: JsonObject, key: String, where: String, areGapsAllowed: Boolean): DoubleArray {
        val json = members[key]
        require(json is JsonArray) { "In $where “$key” must be a list of numbers${if (areGapsAllowed) " and nulls" else ""}." }
        require(json.size <= MAX_SAMPLES) { "In $where “$key” has ${json.size} numbers; at most $MAX_SAMPLES are allowed." }
        return DoubleArray(json.size) { index ->
            val item = json[index]
            if (areGapsAllowed && item is JsonNull) {
                Double.NaN
            } else {
                number(item) ?: throw IllegalArgumentException(
                    "In $where number ${index + 1} of “$key” is ${kindOf(
                        item,
                    )}, not a number${if (areGapsAllowed) "; a gap is null" else ""}.",
                )
            }
        }
    }

    private fun kindOf(json: JsonElement) = when {
        json is JsonObject -> "an object"
        json is JsonArray -> "a list"
        json is JsonNull -> "null"
        (json as JsonPrimitive).isString -> "a text"
        else -> json.content.take(MAX_NAME)
    }

    private const val MAX_QUOTED = 120
    private const val MAX_DEPTH = 10
    private const val MAX_NAME = 200
    private const val MAX_TEXT = 10_000
    private const val MAX_VALUES = 1000
    private const val MAX_FINDINGS = 10_000
    private const val MAX_SERIES = 100
    private const val MAX_SAMPLES = 1_000_000
    private const val MAX_FIGURES = 50
    private const val MAX_FIGURE = 4 shl 20

    // Three bytes are four characters, and there may be line breaks.
    private const val MAX_BASE64 = MAX_FIGURE / 2 * 3
    private val PNG = byteArrayOf(0x89.toByte(), 'P'.code.toByte(), 'N'.code.toByte(), 'G'.code.toByte(), 13, 10, 26, 10)
}
