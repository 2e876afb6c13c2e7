package badlog.assistant

import badlog.assistant.call.AnswerText
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonArray
import kotlinx.serialization.json.JsonElement
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.jsonObject
import java.nio.file.Path
import java.util.Locale
import kotlin.io.path.readText
import kotlin.io.path.writeText

/**
 * Runs the examples of `docs/assistant.md`. An example is a tool with its arguments, followed by the data of the answer. A line `…` matches
 * any lines, and `…` in a line any part of it. With the environment variable `BADLOG_WRITE_GUIDE`, examples that differ are rewritten in
 * full instead.
 */
@Tags("InCheck")
class AssistantGuideSpec : FunSpec({
    val guide = Path.of("../../docs/assistant.md")
    val example = Regex("""(?<=```assistant\n)(.*?)(?=```)""", RegexOption.DOT_MATCHES_ALL)

    fun pattern(lines: String): String = lines.split("…").joinToString(".*") { Regex.escape(it) }

    fun matches(wanted: String, printed: String): Boolean = Regex(wanted.split("\n…\n").joinToString("\n(?:.*\n)*?", transform = ::pattern)).matches(printed)

    test("the tools answer the guide's examples as shown") {
        val text = guide.readText()
        val examples = example.findAll(text).map { it.value }.toList()
        examples.size shouldBeGreaterThan 3
        asking(SAMPLES) {
            val answers = examples.map { block ->
                val call = block.substringBefore('\n')
                val arguments = Json.parseToJsonElement(call.substringAfter(' ')).jsonObject
                val result = call(call.substringBefore(' '), *arguments.map { it.key to it.value }.toTypedArray())
                val said = Conversation.textOf(result)
                if (result.isError == true) "$call\n$said\n" else call + "\n" + lines(Json.parseToJsonElement(said).jsonObject.getValue("data").jsonObject)
            }
            if (System.getenv("BADLOG_WRITE_GUIDE") != null) {
                val next = answers.iterator()
                guide.writeText(example.replace(text) { found -> next.next().let { if (matches(found.value, it)) found.value else it } })
            } else {
                for ((wanted, was) in examples.zip(answers)) if (!matches(wanted, was)) was shouldBe wanted
            }
        }
    }

    test("the guide lists every tool and the current limits") {
        val text = guide.readText()
        asking(SAMPLES) {
            val listed = Regex("""^\| `(\w+)` \|""", RegexOption.MULTILINE).findAll(text).map { it.groupValues[1] }.toList()
            listed shouldContainExactlyInAnyOrder client.listTools().tools.map { it.name }
        }
        text shouldContain "%,d characters".format(Locale.ROOT, AnswerText.MAX_CHARACTERS)
        text shouldContain "%,d characters".format(Locale.ROOT, AnswerText.MAX_TEXT)
    }
})

/** Returns [data] in readable form: a line for each of its parts, and for each entry of a list. */
private fun lines(data: JsonObject): String = data.entries.joinToString("\n", postfix = "\n") { (name, value) ->
    val isList = value is JsonArray && value.any { it !is JsonPrimitive }
    if (isList) "$name:\n" + value.joinToString("\n") { "  ${compact(it)}" } else "$name: ${compact(value)}"
}

private fun compact(element: JsonElement): String = when (element) {
    is JsonObject -> element.entries.joinToString(", ", "{", "}") { (name, value) -> "\"$name\": ${compact(value)}" }
    is JsonArray -> element.joinToString(", ", "[", "]") { compact(it) }
    is JsonPrimitive -> element.toString()
}
