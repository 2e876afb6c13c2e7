package badlog.networktables.record

import badlog.core.python.TestPython
import badlog.core.waiting.eventually
import badlog.files.readRecording
import badlog.formats.LOG_FORMATS
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.maps.shouldContainAll
import io.kotest.matchers.shouldBe
import java.io.BufferedReader
import java.net.BindException
import java.net.ServerSocket
import java.nio.file.Path
import java.util.concurrent.TimeUnit
import kotlin.random.Random

private val PYTHON = TestPython("ntcore, wpiutil.log", "pyntcore")

/** WPILib's own server as `serve.py` runs it. */
private class WpilibServer(val port: Int, vararg arguments: String) : AutoCloseable {
    private val process = PYTHON.running("src/test/python/serve.py", "$port", *arguments)
    private val lines: BufferedReader = process.inputStream.bufferedReader()
    val address = RecordedServer("robot", "NT:") { ServerAddress("127.0.0.1", port) }

    init {
        line() shouldBe "ready"
    }

    fun line(): String = lines.readLine() ?: error("The server ended.")

    /** Sends an empty line, on which the script continues. */
    fun go() = process.outputStream.run {
        write("\n".toByteArray())
        flush()
    }

    override fun close() {
        process.destroyForcibly()
        process.waitFor(60, TimeUnit.SECONDS)
    }
}

/** Returns a free port outside the range that systems assign. It stays free until a server opens it, even repeatedly. */
private fun freePort() = generateSequence { Random.nextInt(20_000, 32_000) }.first { port ->
    try {
        ServerSocket(port).close()
        true
    } catch (_: BindException) {
        false
    }
}

/** Returns the output of WPILib's own reader for [log], by lines and words. */
private fun read(log: Path): List<List<String>> {
    val process = PYTHON.running("../formats/src/jvmTest/python/read_wpilog.py", "$log")
    val lines = process.inputStream.bufferedReader().readLines().map { it.split('\t') }
    process.waitFor() shouldBe 0
    return lines
}

private fun hex(text: String) = text.encodeToByteArray().joinToString("") { "%02x".format(it) }

@Tags("InCheck")
class WpilibServerSpec : FunSpec({
    test("WPILib's reader finds every type that WPILib's server sends, named and described as WPILib's logger does").config(
        enabledOrReasonIf = PYTHON.isHere,
    ) {
        WpilibServer(freePort(), "types").use { server ->
            recording(listOf(server.address)) { running ->
                eventually("the connection") { running.count("connected") == 1 }
                server.go()
                server.line() shouldBe "sent"
                // Two of each topic, and the description of Point.
                eventually("the values to be written") { running.recorder.progress.values == 33L }
                running.close()
                val file = running.files.single()
                file.dropped shouldBe 0
                file.late shouldBe 0
                val lines = read(file.path)
                val types = lines.filter { it[0] == "start" && it[1].startsWith("NT:") }.associate { it[1] to it[2] }
                types shouldBe mapOf(
                    "NT:/boolean" to "boolean",
                    "NT:/int" to "int64",
                    "NT:/double" to "double",
                    "NT:/float" to "float",
                    "NT:/string" to "string",
                    "NT:/json" to "json",
                    "NT:/boolean[]" to "boolean[]",
                    "NT:/int[]" to "int64[]",
                    "NT:/double[]" to "double[]",
                    "NT:/float[]" to "float[]",
                    "NT:/string[]" to "string[]",
                    "NT:/raw" to "raw",
                    "NT:/msgpack" to "msgpack",
                    "NT:/struct" to "struct:Point",
                    "NT:/struct[]" to "struct:Point[]",
                    "NT:/.schema/struct:Point" to "structschema",
                    "NT:plain" to "double",
                )
                val metadata = lines.filter { it[0] == "start" }.associate { it[1] to it[3] }
                metadata.shouldContainAll(
                    mapOf(
                        "NT:/json" to """{"properties":{"unit":"V"},"source":"NT"}""",
                        "NT:/int" to """{"properties":{},"source":"NT"}""",
                    ),
                )
                val values = lines.filter { it[0] == "data" }.groupBy({ it[1] }, { it[4] })
                values.shouldContainAll(
                    mapOf(
                        "NT:/boolean" to List(2) { "true" },
                        "NT:/int" to List(2) { "9007199254740993" },
                        "NT:/double" to List(2) { "0x1.999999999999ap-4" },
                        "NT:/float" to List(2) { "0x1.8000000000000p+0" },
                        "NT:/string" to List(2) { hex("größer") },
                        "NT:/json" to List(2) { hex("""{"a":1}""") },
                        "NT:/boolean[]" to List(2) { "0100" },
                        "NT:/int[]" to List(2) { "0100000000000000feffffffffffffff" },
                        "NT:/double[]" to List(2) { "9a9999999999b93f0000000000000040" },
                        "NT:/float[]" to List(2) { "0000c03f" },
                        "NT:/string[]" to List(2) { "02000000010000006100000000" },
                        "NT:/raw" to List(2) { "010203" },
                        "NT:/msgpack" to List(2) { "c0" },
                        "NT:/struct" to List(2) { "000000000000f03f0000000000000040" },
                        "NT:/struct[]" to List(2) { "000000000000f03f000000000000004000000000000008400000000000001040" },
                    ),
                )
                // badlog's own reader.
                val recording = readRecording(file.path, LOG_FORMATS)
                recording.problems.filter { it.message.contains("lost") || it.message.contains("dropped") }.shouldBeEmpty()
                recording.topics.single { it.name == "NT:/struct/y" }.samples.toList() shouldBe listOf(2.0, 2.0)
                recording.topics.single { it.name == "NT:/double" }.unit shouldBe "m"
            }
        }
    }

    test("10,000 values a second are all recorded in order").config(enabledOrReasonIf = PYTHON.isHere) {
        val seconds = System.getProperty("badlog.record.loadSeconds", "3").toInt()
        WpilibServer(freePort(), "load", "10000", "$seconds").use { server ->
            recording(listOf(server.address)) { running ->
                eventually("the connection") { running.count("connected") == 1 }
                server.go()
                server.line() shouldBe "sent ${10_000 * seconds}"
                eventually("the values to be written") { running.recorder.progress.values == 10_000L * seconds }
                running.close()
                val file = running.files.single()
                file.dropped shouldBe 0
                file.late shouldBe 0
                file.gaps shouldBe 0
                val log = logIn(file.path)
                for (topic in 0 until 100) log.entry("NT:/load/$topic").numbers() shouldBe List(100 * seconds) { topic + 100.0 * it }
            }
        }
    }

    test("a restarted server is recorded again, in the same log if its clock continues").config(enabledOrReasonIf = PYTHON.isHere) {
        val port = freePort()
        var server = WpilibServer(port, "types")
        try {
            recording(listOf(server.address)) { running ->
                eventually("the connection") { running.count("connected") == 1 }
                server.go()
                eventually("the values to be written") { running.recorder.progress.values == 33L }
                server.close()
                eventually("the lost connection to be noticed") { running.count("disconnected") == 1 }
                server = WpilibServer(port, "types")
                eventually("the connection") { running.count("connected") == 2 }
                server.go()
                // The description of Point is the same, with the same time.
                eventually("the values to be written") { running.recorder.progress.values == 65L }
                // Without a robot, WPILib's clock is the computer's and does not restart.
                val log = running.logs().single()
                log.entry("Recorder/Connected").truths() shouldBe listOf(true, false, true)
                log.entry("NT:/double").numbers() shouldBe listOf(0.1, 0.1, 0.1, 0.1)
                log.entry("NT:/double").times().let { it shouldBe it.sorted() }
                log.entry("messages").texts().filter { "was lost" in it }.size shouldBe 1
            }
        } finally {
            server.close()
        }
    }
})
