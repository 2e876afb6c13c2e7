package badlog.assistant.call

import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.doubleOrNull

/**
 * What an assistant gives to a tool. An assistant makes mistakes, so each is reported with what would be right.
 *
 * @param given as it came.
 * @param parameters what the tool may be given.
 * @throws ToolException when something else is given.
 */
internal class Arguments(private val given: JsonObject, parameters: List<Parameter>) {
    init {
        val known = parameters.map { it.name }
        given.keys.firstOrNull { it !in known }?.let { name ->
            throw ToolException("There is no argument “${name.take(MAX_SHOWN)}”; there are ${known.joinToString()}.")
        }
        for (parameter in parameters.filter { it.isRequired }) {
            if (find(parameter.name) == null) throw ToolException("The argument “${parameter.name}” is missing: ${parameter.description}")
        }
    }

    /** The text [name]; null where it is not given. */
    fun text(name: String): String? = find(name)?.let { textOf(name, it) }

    /** The text [name], which is required. */
    fun requiredText(name: String): String = text(name) ?: throw ToolException("The argument “$name” is missing.")

    /** The texts [name]; a single one may stand without a list. Empty where none is given. */
    fun texts(name: String): List<String> {
        val element = find(name) ?: return emptyList()
        val texts = if (element is JsonArray) element.map { textOf(name, it) } else listOf(textOf(name, element))
        if (texts.size > MAX_TEXTS) throw ToolException("“$name” has ${texts.size} entries; give at most $MAX_TEXTS.")
        return texts
    }

    /** The number [name]; null where it is not given. */
    fun number(name: String): Double? = find(name)?.let {
        (it as? JsonPrimitive)?.doubleOrNull?.takeIf(Double::isFinite) ?: throw ToolException("“$name” must be a number.")
    }

    /** The whole number [name], which lies in [range], or [default]. */
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
        if (text.length > MAX_LETTERS) throw ToolException("“$name” is longer than $MAX_LETTERS characters; shorten it.")
        return text
    }

    companion object {
        /** So many entries may a list have. */
        const val MAX_TEXTS: Int = 50

        /** So many characters may a text have. */
        const val MAX_LETTERS: Int = 2_000

        private const val MAX_SHOWN = 60
    }
}
