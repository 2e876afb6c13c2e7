package badlog.assistant

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll
import kotlinx.coroutines.runBlocking
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.int
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import java.io.ByteArrayInputStream
import java.io.ByteArrayOutputStream
import java.io.PipedInputStream
import java.io.PipedOutputStream

class UnparsableRequestSpec : FunSpec({
    test("a line that is not JSON is answered with the error that JSON-RPC has for it, and the next request is answered") {
        val requests = PipedOutputStream()
        val input = PipedInputStream(requests)
        val answers = PipedOutputStream()
        val lines = PipedInputStream(answers).bufferedReader()
        val serving = Thread { runBlocking { AssistantServer(emptyList(), "logs").serve(input, answers) } }.apply { start() }
        requests.write("{\"jsonrpc\":\"2.0\",\"id\":1,\"meth\nnonsense\n\n{\"jsonrpc\":\"2.0\",\"id\":7,\"method\":\"ping\"}\n".encodeToByteArray())
        requests.flush()
        val read = List(3) { Json.parseToJsonElement(lines.readLine()).jsonObject }
        read.map { it.getValue("id") to it["error"]?.jsonObject?.getValue("code")?.jsonPrimitive?.int }
            .map { (id, code) -> (if (id == JsonNull) "null" else id.jsonPrimitive.content) to code }
            .shouldContainExactlyInAnyOrder("null" to -32700, "null" to -32700, "7" to null)
        requests.close()
        serving.join()
    }

    test("lines of JSON pass unchanged, and other lines are counted") {
        val texts = Arb.element("{\"a\":1}", "[1,2]", "", "  ", "{", "nonsense here", "{\"ü\":\"\\n\"}", "}{", "{}\r", "nonsense")
        checkAll(Arb.list(texts, 0..20), Arb.int(1, 50)) { lines, size ->
            var others = 0
            val read = ByteArrayOutputStream()
            val stream = JsonLines(ByteArrayInputStream(lines.joinToString("") { "$it\n" }.encodeToByteArray())) { others++ }
            val piece = ByteArray(size)
            while (true) {
                val count = stream.read(piece)
                if (count < 0) break
                read.write(piece, 0, count)
            }
            val broken = setOf("{", "nonsense here", "nonsense", "}{")
            read.toString(Charsets.UTF_8) shouldBe lines.filter { it !in broken }.joinToString("") { "$it\n" }
            others shouldBe lines.count { it in broken }
        }
    }
})
