package badlog.assistant.call

import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.buildJsonObject
import kotlinx.serialization.json.put
import kotlinx.serialization.json.putJsonObject

/**
 * A tool for an assistant. It only reads.
 *
 * @property name its name for the assistant, in lower-case letters and `_`.
 * @property title its name for people.
 * @property description its purpose, in sentences for the assistant.
 * @property parameters its parameters.
 */
internal abstract class AssistantTool(val name: String, val title: String, val description: String, val parameters: List<Parameter>) {
    /**
     * Answers a call with [arguments].
     *
     * @throws ToolException if they are invalid.
     */
    abstract fun answer(arguments: Arguments): Answer
}

/** The types of arguments, with their names in JSON Schema. */
internal enum class ParameterType {
    TEXT,
    TEXTS,
    NUMBER,
    WHOLE,
}

/**
 * A parameter of a tool.
 *
 * @property description its meaning, unit and default.
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
