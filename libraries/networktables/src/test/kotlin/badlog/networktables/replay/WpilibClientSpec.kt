package badlog.networktables.replay

import badlog.core.analysis.LogView
import badlog.core.python.TestPython
import badlog.core.waiting.eventually
import badlog.files.readRecording
import badlog.networktables.TopicType
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import kotlinx.serialization.json.long
import java.io.File
import java.util.concurrent.ConcurrentLinkedQueue
import java.util.concurrent.TimeUnit
import kotlin.concurrent.thread

private val PYTHON = TestPython("ntcore", "pyntcore")

/**
 * Returns the lines of WPILib's client for a replay. It has [values] values from start to end, then [more] values after a jump back to the
 * start.
 *
 * The client gives up a server that is silent for about a second, as on a busy machine, and reconnects to the current values. Its lines do
 * not count then, and the replay is repeated.
 */
private fun linesOf(view: LogView, options: ReplayOptions, values: Int, more: Int = 0, logged: List<LoggedTopic> = emptyList()): List<JsonObject> {
    for (attempt in 1..20) {
        val lines = ReplayServer(view, options, logged).use { linesOf(it, signalsOf(view, options.prefix, logged).size, values, more) }
        if (lines.none { "lost" in it }) return lines
    }
    error("WPILib’s client lost its connection in each of 20 replays.")
}

private fun linesOf(server: ReplayServer, topics: Int, values: Int, more: Int): List<JsonObject> {
    server.open()
    val client = PYTHON.running("src/test/python/listen.py", "${server.port}", "$topics")
    return try {
        val lines = ConcurrentLinkedQueue<JsonObject>()
        val reader = thread {
            client.inputStream.bufferedReader().forEachLine { lines += Json.parseToJsonElement(it).jsonObject }
        }
        fun isLost() = lines.any { "lost" in it }
        eventually("the client to know all topics") { isLost() || lines.any { "ready" in it } }
        server.start()
        eventually("the end") { server.isAtEnd }
        eventually("all values") { isLost() || lines.count { "value" in it } >= values }
        // Later values show that no other value came before them.
        server.pause()
        server.seek(server.range.start)
        eventually("what holds at the start") { isLost() || lines.count { "value" in it } >= values + more }
        client.outputStream.close()
        client.waitFor(60, TimeUnit.SECONDS) shouldBe true
        client.exitValue() shouldBe 0
        reader.join()
        server.note shouldBe null
        lines.toList()
    } finally {
        client.destroyForcibly()
    }
}

/** The value as text, because NaN is not equal to itself. */
private fun ReplayedTopic.textAt(index: Int): String = when (type) {
    TopicType.BOOLEAN -> "${samples.y[index] != 0.0}"
    TopicType.DOUBLE -> "${samples.y[index]}"
    TopicType.INT -> "${samples.y[index].toLong()}"
    TopicType.STRING -> texts[samples.y[index].toInt()].decodeToString()
    else -> error("not of a bag")
}

private fun JsonPrimitive.textAs(type: TopicType): String = when (type) {
    TopicType.DOUBLE -> "${content.toDouble()}"
    else -> content
}

/** Compares the received values with the recording: every topic, every sample, and the server's time of each. */
private fun shouldArrive(view: LogView, options: ReplayOptions) {
    val signals = signalsOf(view, options.prefix)
    val range = options.range ?: rangeOf(signals)

    // The values at the start, then every sample.
    fun ReplayedTopic.sent() = maxOf(countUntil(range.start) - 1, 0) until countUntil(range.endInclusive)
    fun ReplayedTopic.heldAtStart() = if (countUntil(range.start) > 0) 1 else 0
    val lines = linesOf(view, options, signals.sumOf { it.sent().count() }, signals.sumOf { it.heldAtStart() })
    val announced = lines.filter { "topic" in it }.associateBy { it.getValue("topic").jsonPrimitive.content }
    announced.keys shouldBe signals.map { it.name }.toSet()
    val values = lines.filter { "value" in it }.groupBy { it.getValue("of").jsonPrimitive.content }
    // The server's time when the playhead began to move, calculated from each sample.
    val begins = ArrayList<Double>()
    for (signal in signals) {
        val topic = announced.getValue(signal.name)
        topic.getValue("type").jsonPrimitive.content shouldBe signal.type.typeName
        topic.getValue("properties") shouldBe propertiesOf(signal)
        val expected = signal.sent().toList()
        val arrived = values[signal.name].orEmpty().dropLast(signal.heldAtStart())
        arrived.map { it.getValue("value").jsonPrimitive.textAs(signal.type) } shouldBe expected.map(signal::textAt)
        for ((line, index) in arrived zip expected) {
            if (signal.samples.x[index] <= range.start) continue
            val micros = line.getValue("micros").jsonPrimitive.long
            begins += micros - (signal.samples.x[index] - range.start) * 1e6 / options.speed
        }
    }
    // To the microsecond, for all topics alike.
    (begins.max() - begins.min()) shouldBe (0.0 plusOrMinus 2.0)
}

@Tags("InCheck")
class WpilibClientSpec :
    FunSpec({
        test("topics of every kind arrive with their type, unit, order and timing").config(enabledOrReasonIf = PYTHON.isHere) {
            for (speed in listOf(1.0, 0.25)) shouldArrive(VARIED_VIEW, ReplayOptions(0, speed = speed))
        }

        test("logged values arrive with their type, byte by byte").config(enabledOrReasonIf = PYTHON.isHere) {
            fun topic(name: String, type: String, vararg bytes: Int) = LoggedTopic(name, type, "", doubleArrayOf(10.1)) {
                ByteArray(bytes.size) { bytes[it].toByte() }
            }
            val logged = listOf(
                topic("Pose", "struct:Pose2d", 1, 2, 3) to "[1,2,3]",
                topic("/.schema/struct:Pose2d", "structschema", 120) to "[120]",
                topic("Ticks", "int64", 1, 0, 0, 0, 0, 0, 32, 0) to "9007199254740993",
                topic("Powers", "double[]", 0, 0, 0, 0, 0, 0, 0xf0, 0x3f) to "[1.0]",
                topic("Names", "string[]", 1, 0, 0, 0, 1, 0, 0, 0, 97) to "[\"a\"]",
                topic("Flags", "boolean[]", 1, 0) to "[true,false]",
            )
            val lines = linesOf(VARIED_VIEW, ReplayOptions(0), logged.size, logged = logged.map { it.first })
            for ((topic, value) in logged) {
                val name = "/" + topic.name.trimStart('/')
                val type = if (topic.type == "int64") "int" else topic.type
                lines.single { it["topic"]?.jsonPrimitive?.content == name }.getValue("type").jsonPrimitive.content shouldBe type
                "${lines.first { it["of"]?.jsonPrimitive?.content == name }["value"]}" shouldBe value
            }
        }

        test("a match arrives sample by sample at three times its speed").config(enabledOrReasonIf = PYTHON.isHere) {
            val view = LogView.of(readRecording(File("../../samples/qualification-42.bag").toPath(), emptyList()))
            shouldArrive(view, ReplayOptions(0, speed = 3.0, range = 20.0..26.0, prefix = "/badlog"))
        }
    })
