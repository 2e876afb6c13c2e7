package badlog.assistant.call

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.doubleOrNull

/**
 * The arguments that an assistant passes to a tool. Assistants make mistakes, so each mistake is reported with a correction.
 *
 * @param given the arguments as received.
 * @param parameters the parameters of the tool.
 * @throws ToolException if an argument is unknown.
 */
internal class Arguments(private val given: JsonObject, parameters: List<Parameter>) {
    init {
        val known = parameters.map { it.name }
        given.keys.firstOrNull { it !in known }?.let { name ->
            throw ToolException("“${name.take(MAX_SHOWN)}” is not an argument; use ${known.joinToString()}.")
        }
        for (parameter in parameters.filter { it.isRequired }) {
            if (find(parameter.name) == null) throw ToolException("The argument “${parameter.name}” is missing: ${parameter.description}")
        }
    }

    /** Returns the value of the text argument [name]; null if it is not given. */
    fun text(name: String): String? = find(name)?.let { textOf(name, it) }

    /** Returns the text [name], which is required. */
    fun requiredText(name: String): String = text(name) ?: throw ToolException("The argument “$name” is missing.")

    /** Returns the texts in the argument [name], a list or a single text. Empty if it is not given. */
    fun texts(name: String): List<String> {
        val element = find(name) ?: return emptyList()
        val texts = if (element is JsonArray) element.map { textOf(name, it) } else listOf(textOf(name, element))
        if (texts.size > MAX_TEXTS) throw ToolException("“$name” has ${texts.size} entries; give at most $MAX_TEXTS.")
        return texts
    }

    /** Returns the number [name]; null if it is not given. */
    fun number(name: String): Double? = find(name)?.let {
        (it as? JsonPrimitive)?.doubleOrNull?.takeIf(Double::isFinite) ?: throw ToolException("“$name” must be a number.")
    }

    /** Returns the whole number [name], which must be in [range]; [default] if it is not given. */
    fun whole(name: String, default: Int, range: IntRange): Int {
        val number = number(name) ?: return default
        if (number != Math.rint(number) || number < range.first || number > range.last) {
            throw ToolException("“$name” must be a whole number from ${range.first} to ${range.last}.")
        }
        return number.toInt()
    }

    private fun find(name: String): JsonElement? = given[name]?.takeIf { it != JsonNull }

    private fun textOf(name: String, element: JsonElement): String {
        val text = (element as? JsonPrimitive)?.takeIf { it.isString }?.content ?: throw ToolException("“$name” must be a text.")
        if (text.length > MAX_TEXT_LENGTH) throw ToolException("“$name” is longer than $MAX_TEXT_LENGTH characters; shorten it.")
        return text
    }

    companion object {
        /** The maximum number of entries in a list. */
        const val MAX_TEXTS: Int = 50

        /** The maximum number of characters in a text. */
        const val MAX_TEXT_LENGTH: Int = 2_000

        private const val MAX_SHOWN = 60
    }
}
