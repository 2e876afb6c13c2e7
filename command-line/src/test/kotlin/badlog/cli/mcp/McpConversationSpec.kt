package badlog.cli.mcp

import badlog.cli.ROOT
import badlog.cli.SAMPLES
import badlog.cli.plugin.javaCommand
import badlog.core.python.TestPython
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.doubles.shouldBeGreaterThan
import io.kotest.matchers.ints.shouldBeGreaterThanOrEqual
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.boolean
import kotlinx.serialization.json.double
import kotlinx.serialization.json.int
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import kotlin.io.path.div

private val PYTHON = TestPython("mcp.client.client", "mcp 2")

/** The conversation of an assistant with the installed program, held by a client that shares no code with it. */
@Tags("InCheck")
class McpConversationSpec : FunSpec({
    test("an assistant finds out why Qualification 42 browned out, question by question").config(enabledOrReasonIf = PYTHON.isHere) {
        val script = ROOT / "command-line/src/test/python/brownout.py"
        val python = PYTHON.running(script.toString(), *javaCommand("mcp", SAMPLES.toString()).toTypedArray())
        val said = python.inputStream.readAllBytes().decodeToString()
        python.waitFor() shouldBe 0
        val found = Json.parseToJsonElement(said).jsonObject
        found.getValue("log").jsonPrimitive.content shouldBe "qualification-42.bag"
        found.getValue("timeUnit").jsonPrimitive.content shouldBe "s"
        found.getValue("evidence").jsonArray.map { it.jsonPrimitive.content } shouldContain "System/Battery Voltage"
        found.getValue("sentences").jsonArray.joinToString("\n") { it.jsonPrimitive.content } shouldContain "rown"
        // The planted faults, see samples/README.md.
        found.getValue("lowest").jsonPrimitive.double shouldBe 6.73
        found.getValue("lowestAt").jsonPrimitive.double shouldBe (93.7 plusOrMinus 0.2)
        found.getValue("current").jsonObject.getValue("value").jsonPrimitive.double shouldBeGreaterThan 230.0
        found.getValue("brownouts").jsonPrimitive.int shouldBe 5
        found.getValue("rows").jsonPrimitive.int shouldBeGreaterThanOrEqual 3
        found.getValue("worst").jsonArray.map { it.jsonPrimitive.content } shouldBe listOf("qualification-42.bag", "6.73")
        found.getValue("isPng").jsonPrimitive.boolean shouldBe true
        found.getValue("isRefused").jsonPrimitive.boolean shouldBe true
    }
})
