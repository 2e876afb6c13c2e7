package badlog.cli.cut

import badlog.cli.Logged
import badlog.cli.badlog
import badlog.cli.badlogJson
import badlog.cli.command.ExitCode
import badlog.cli.sampleLog
import badlog.cli.wpilog
import badlog.core.analysis.Span
import badlog.core.recording.Recording
import badlog.core.recording.TopicKind
import badlog.files.inFolder
import badlog.files.readRecording
import badlog.formats.LOG_FORMATS
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.property.Arb
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.map
import io.kotest.property.arbitrary.pair
import io.kotest.property.checkAll
import kotlinx.serialization.json.int
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonPrimitive
import kotlin.io.path.div

/** What [name] holds: its times, with its number or text at each. */
private fun Recording.held(name: String): List<String> {
    val topic = topics.single { it.name == name }
    val texts = List(topic.texts.size) { topic.texts.rows[it] to topic.texts[it] }.toMap()
    return checkNotNull(topic.times).mapIndexed { i, time -> "$time ${texts[i] ?: topic.samples[i]}" }
}

class CutWpilogSpec : FunSpec({
    /** Speed rises by 1 a second from 0 at 1 s on. The robot is enabled from 2 to 4 s and from 6 to 7 s. */
    val log = listOf(
        Logged("Speed", "double", "{\"unit\":\"m/s\"}", (1..8).map { it * 1.0 to it - 1.0 }),
        Logged("Count", "int64", "{\"a\":1}", listOf(1.5 to 7.0)),
        Logged("DS:enabled", "boolean", "", listOf(1.0 to false, 2.0 to true, 4.0 to false, 6.0 to true, 7.0 to false)),
        Logged("Mode", "string", "", listOf(1.0 to "IDLE", 3.5 to "RUN", 7.5 to "IDLE")),
        Logged("messages", "string", "", listOf(1.2 to "hello", 3.0 to "RUN now", 7.2 to "bye")),
        Logged("Late", "float", "", listOf(7.9 to 0.5)),
        Logged("systemTime", "int64", "", listOf(1.0 to 1.7e15)),
    )

    fun cut(vararg options: String): Recording = inFolder { folder ->
        badlog("cut", folder.wpilog("a.wpilog", log), *options).code shouldBe ExitCode.WHOLE
        readRecording(folder / "a.cut.wpilog", LOG_FORMATS)
    }

    test("a part begins with the current value of each topic, without repeating events") {
        val part = cut("--from", "2.5", "--to", "4")
        part.held("Speed") shouldContainExactly listOf("2.5 1.0", "3.0 2.0", "4.0 3.0")
        part.held("Count") shouldContainExactly listOf("2.5 7.0")
        part.held("DS:enabled") shouldContainExactly listOf("2.5 1.0", "4.0 0.0")
        part.held("Mode") shouldContainExactly listOf("2.5 IDLE", "3.5 RUN")
        part.held("messages") shouldContainExactly listOf("3.0 RUN now")
        part.held("Late") shouldContainExactly emptyList()
        part.held("systemTime") shouldContainExactly emptyList()
    }

    test("a sample at the very beginning is the first value") {
        cut("--from", "2", "--to", "2").held("Speed") shouldContainExactly listOf("2.0 1.0")
        cut("--to", "1").held("Speed") shouldContainExactly listOf("1.0 0.0")
    }

    test("types, metadata, units and values stay") {
        val part = cut("--from", "2.5", "--to", "9")
        part.topics.map { it.name } shouldContainExactly log.map { it.name }
        part.topics.map { it.type } shouldContainExactly log.map { it.type }
        part.topics.map { it.metadata } shouldContainExactly log.map { it.metadata }
        part.topics[0].unit shouldBe "m/s"
    }

    test("--enabled keeps the enabled parts, each with the values at its beginning") {
        val part = cut("--enabled")
        part.held("Speed") shouldContainExactly
            listOf("2.0 1.0", "3.0 2.0", "4.0 3.0", "6.0 5.0", "7.0 6.0")
        part.held("Mode") shouldContainExactly listOf("2.0 IDLE", "3.5 RUN", "6.0 RUN")
        part.held("Count") shouldContainExactly listOf("2.0 7.0", "6.0 7.0")
        cut("--enabled", "--from", "5", "--margin", "0.5").held("Speed") shouldContainExactly
            listOf("5.5 4.0", "6.0 5.0", "7.0 6.0")
    }

    test("--around keeps the surroundings of events and beginnings of states") {
        cut("--around", "run", "--before", "0", "--after", "0").held("Mode") shouldContainExactly listOf("3.0 IDLE", "3.5 RUN")
    }

    test("events stay events, even where few are left") {
        val many = Logged("Said", "string", "", List(20) { it * 1.0 to "said $it" })
        inFolder { folder ->
            badlog("cut", folder.wpilog("a.wpilog", listOf(many)), "--from", "18").code shouldBe ExitCode.WHOLE
            readRecording(folder / "a.wpilog", LOG_FORMATS).topics.single().kind shouldBe TopicKind.EVENT
            readRecording(folder / "a.cut.wpilog", LOG_FORMATS).topics.single().attributes shouldContainExactly listOf("log")
        }
    }

    test("the number of kept samples is reported, also in JSON, and an error names the existing range") {
        inFolder { folder ->
            val whole = folder.wpilog("a.wpilog", log)
            badlog("cut", whole, "--from", "2.5", "--to", "4").out shouldContain "kept 9 of 22 samples\n  from 2.5 s to 4 s\n"
            val json = badlogJson("cut", whole, "--enabled", "-o", folder / "b.wpilog").json.single()
            json.getValue("ofSamples").jsonPrimitive.int shouldBe 22
            json.getValue("parts").jsonArray.size shouldBe 2
            val beyond = badlog("cut", whole, "--from", "9", "-o", folder / "c.wpilog")
            beyond.code shouldBe ExitCode.NOTHING
            beyond.err shouldContain "there are no samples there; Time goes from 1 s to 8 s"
            badlog("cut", whole, "--from", "3", "-o", folder / "c.bag").err shouldContain "needs rows"
            badlog("cut", whole, "--from", "3", "--x", "Speed").err shouldContain "whose x axis is always the time"
        }
    }

    test("a bag can be cut into a WPILOG") {
        inFolder { folder ->
            val bag = folder / "a.bag"
            badlog("convert", folder.sampleLog("practice.bag"), "--rows-at", "Time", "-o", bag).code shouldBe ExitCode.WHOLE
            badlog("cut", bag, "--from", "10", "--to", "12", "-o", folder / "b.wpilog").code shouldBe ExitCode.WHOLE
            val speed = readRecording(folder / "b.wpilog", LOG_FORMATS).topics.first { it.name == "System/Battery Voltage" }
            (speed.size in 99..101) shouldBe true
        }
    }

    test("at any time of a part, every value equals the whole log's") {
        val places = Arb.int(0, 60)
        checkAll(Arb.list(places, 1..20), Arb.list(Arb.pair(places, places), 1..4)) { samples, pairs ->
            val times = samples.sorted().map { it.toDouble() }.toDoubleArray()
            val spans = joined(pairs.map { (a, b) -> Span(minOf(a, b) + 0.5, maxOf(a, b) + 0.5) })
            val part = ClockPart.Cache(spans, holdsValues = true).of(times)
            fun heldAt(at: Double, all: DoubleArray) = all.indices.lastOrNull { all[it] <= at }
            part.times.toList() shouldBe part.times.sorted()
            for (span in spans) {
                var at = span.from
                while (at <= span.to) {
                    val value = heldAt(at, part.times)?.let { part.indices[it] }
                    value shouldBe heldAt(at, times)
                    at += 0.25
                }
            }
            val happened = ClockPart.Cache(spans, holdsValues = false).of(times)
            happened.indices.toList() shouldBe times.indices.filter { index -> spans.any { times[index] in it } }
        }
    }

    test("spans are in an intersection where they are in both") {
        val span = Arb.pair(Arb.int(0, 20), Arb.int(0, 20)).map { (a, b) -> Span(minOf(a, b) * 1.0, maxOf(a, b) * 1.0) }
        val some = Arb.list(span, 0..5)
        checkAll(some, some) { one, other ->
            val both = intersection(joined(one), joined(other))
            for (half in 0..40) {
                val x = half / 2.0
                both.any { x in it } shouldBe (one.any { x in it } && other.any { x in it })
            }
        }
    }
})
