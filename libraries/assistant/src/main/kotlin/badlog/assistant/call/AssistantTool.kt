package badlog.assistant.call

import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put
import kotlinx.serialization.json.putJsonObject

/**
 * Something that an assistant may ask for. It only reads.
 *
 * @property name what the assistant calls it, in small letters and `_`.
 * @property title what a person calls it.
 * @property description what it is for, in sentences for the assistant.
 * @property parameters what it may be given.
 */
internal abstract class AssistantTool(val name: String, val title: String, val description: String, val parameters: List<Parameter>) {
    /**
     * Answers what [arguments] ask for.
     *
     * @throws ToolException when that makes no sense.
     */
    abstract fun answer(arguments: Arguments): Answer
}

/** The types that arguments may have, as JSON Schema calls them. */
internal enum class ParameterType {
    TEXT,
    TEXTS,
    NUMBER,
    WHOLE,
}

/**
 * What a tool may be given.
 *
 * @property description what it means, with its unit and its default.
 */
internal class Parameter(val name: String, val type: ParameterType, val description: String, val isRequired: Boolean = false) {
    /** This parameter in JSON Schema. */
    fun schema(): JsonObject = buildJsonObject {
        when (type) {
            ParameterType.TEXT -> put("type", "string")

            ParameterType.NUMBER -> put("type", "number")

            ParameterType.WHOLE -> put("type", "integer")

            ParameterType.TEXTS -> {
                put("type", "array")
                putJsonObject("items") { put("type", JsonPrimitive("string")) }
            }
        }
        put("description", description)
    }
}
