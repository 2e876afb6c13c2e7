package badlog.cli.convert

import badlog.cli.Logged
import badlog.cli.SAMPLES
import badlog.cli.badlog
import badlog.cli.badlogJson
import badlog.cli.command.ExitCode
import badlog.cli.names
import badlog.cli.sampleLog
import badlog.cli.with
import badlog.cli.wpilog
import badlog.core.recording.Recording
import badlog.core.recording.RecordingFormat
import badlog.files.inFolder
import badlog.files.readRecording
import badlog.formats.LOG_FORMATS
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.property.Arb
import io.kotest.property.arbitrary.Codepoint
import io.kotest.property.arbitrary.arbitrary
import io.kotest.property.arbitrary.az
import io.kotest.property.arbitrary.boolean
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.filter
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.map
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll
import kotlinx.serialization.json.int
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonPrimitive
import java.nio.file.Path
import java.util.zip.GZIPInputStream
import kotlin.io.path.div
import kotlin.io.path.fileSize
import kotlin.io.path.inputStream
import kotlin.io.path.readBytes

/** All that a recording says of its topics and values; as text, because NaN does not equal NaN. */
private fun contentOf(recording: Recording): List<String> = recording.values.map { it.toString() } + recording.topics.map { topic ->
    val texts = List(topic.texts.size) { "${topic.texts.rows[it]}: ${topic.texts[it]}" }
    "${topic.name} ${topic.unit} ${topic.attributes.sorted()} ${topic.kind} ${topic.samples.joinToString()} $texts"
}

/** Words that a bag reads as no text: as a number, a truth value or an empty cell. */
private val NO_EVENTS = setOf("inf", "nan", "true", "false", "null")

/** A bag in which every topic has a value in every row, or is numeric, or an event log. */
private val bags: Arb<String> = arbitrary { random ->
    val unit = Arb.element("s", "ms", "us").bind()
    val step = if (unit == "s") {
        1e-6
    } else if (unit == "ms") {
        1e-3
    } else {
        1.0
    }
    val numbers = Arb.double().filter { !it.isNaN() }
    val modes = Arb.element("IDLE", "RUN", "a, \"b\"", "Ω").map { "\"${it.replace("\"", "\"\"")}\"" }
    val words = Arb.string(1..6, Codepoint.az())
    val header = """{"topics":[{"name":"Drive/Speed","unit":"m/s","attrs":["delta","zero"]},{"name":"T","unit":"$unit",""" +
        """"attrs":["hide","xaxis"]},{"name":"On"},{"name":"Mode"},{"name":"Log","attrs":["log"]},{"name":"messages","attrs":["log"]}],""" +
        """"values":[{"name":"Match Number","value":"${words.bind()}"},{"name":"T","value":"a \"b\""}]}"""
    var x = Arb.int(0, 5).bind() * step
    val rows = List(Arb.int(1, 30).bind()) { row ->
        x += step * (2 + Arb.int(0, 100_000).bind() + random.random.nextDouble() / 4)
        val number = if (row > 0 && Arb.int(0, 4).bind() == 0) "NaN" else numbers.bind().toString()
        val event = if (Arb.boolean().bind()) words.filter { it !in NO_EVENTS }.bind() else ""
        "$number,$x,${Arb.boolean().bind()},${modes.bind()},$event,"
    }
    "$header\nDrive/Speed,T,On,Mode,Log,messages\n${rows.joinToString("\n")}\n"
}

@Tags("InCheck")
class ConvertWpilogSpec : FunSpec({
    fun leftOut(folder: Path, vararg arguments: Any): List<String> = badlogJson("convert", *arguments, "--force").json.single().getValue("leftOut").jsonArray.map { it.jsonPrimitive.content }

    test("a bag comes back from a WPILOG with the same numbers, texts, units, attributes and values") {
        inFolder { folder ->
            checkAll(bags) { text ->
                val bag = folder.with("a.bag", text)
                badlog("convert", bag, "-o", folder / "a.wpilog", "--force").code shouldBe ExitCode.WHOLE
                badlog("convert", folder / "a.wpilog", "-o", folder / "b.bag", "--rows-at", "t", "--force").code shouldBe ExitCode.WHOLE
                contentOf(readRecording(folder / "b.bag", LOG_FORMATS)) shouldBe contentOf(readRecording(bag, LOG_FORMATS))
            }
        }
    }

    test("each sample log comes back from a WPILOG, with all of its gaps and events") {
        inFolder { folder ->
            for (name in listOf("qualification-42.bag", "practice.bag", "qualification-57.bag.gz")) {
                val log = folder / "log.wpilog.gz"
                badlog("convert", SAMPLES / name, "-o", log, "--force")
                log.readBytes()[0] shouldBe 0x1f
                badlog("convert", log, "--rows-at", "Time", "-o", folder / "back.bag", "--force").code shouldBe ExitCode.WHOLE
                contentOf(readRecording(folder / "back.bag", LOG_FORMATS)) shouldBe contentOf(readRecording(SAMPLES / name, LOG_FORMATS))
            }
        }
    }

    test("content that a WPILOG cannot hold is listed, by topic in JSON") {
        inFolder { folder ->
            val bag = folder.with(
                "a.bag",
                "{\"topics\":[{\"name\":\"x\",\"unit\":\"m\",\"attrs\":[\"xaxis\"]},{\"name\":\"n\"},{\"name\":\"on\"}," +
                    "{\"name\":\"e\",\"attrs\":[\"log\"]}]}\nx,n,on,e\n0,1,true,hit\n1,,,miss\n2,oops,false,inf\n3,4,true,hit\n",
            )
            val ended = badlog("convert", "--to", "wpilog", bag)
            ended.code shouldBe ExitCode.WHOLE
            ended.out shouldContain "16 samples of 4 topics\n"
            ended.out shouldContain "differs: The x axis “x (m)” is not a time; one unit is written as one second.\n"
            leftOut(folder, "--to", "wpilog", bag) shouldContainExactly listOf(
                "The x axis “x (m)” is not a time; one unit is written as one second.",
                "“n”: Each gap starts with NaN.",
                "“n”: Texts among numbers have no record.",
                "“on”: Empty cells have no record.",
                "“e”: Numbers among texts have no record.",
            )
            folder.names() shouldContainExactly listOf("a.bag", "a.wpilog")
        }
    }

    test("a WPILOG becomes a WPILOG, and --changes-only leaves out repetitions") {
        inFolder { folder ->
            val log = folder.sampleLog("practice.bag")
            badlog("convert", log, "-o", folder / "copy.wpilog").code shouldBe ExitCode.WHOLE
            (folder / "copy.wpilog").readBytes().toList() shouldBe log.readBytes().toList()
            val raw = folder.wpilog("raw.wpilog", listOf(Logged("photo", "raw", "", listOf(1.0 to "bytes", 2.0 to "more"))))
            leftOut(folder, raw, "-o", folder / "raw.wpilog.gz").shouldBeEmpty()
            GZIPInputStream((folder / "raw.wpilog.gz").inputStream()).use { it.readBytes() }.toList() shouldBe raw.readBytes().toList()
            leftOut(folder, raw, "--changes-only", "-o", folder / "changed.wpilog").shouldBeEmpty()
            leftOut(folder, log, "--changes-only", "-o", folder / "changes.wpilog").single() shouldContain
                "Samples that repeat the previous one have no record"
            ((folder / "changes.wpilog").fileSize() < log.fileSize()) shouldBe true
            badlog("convert", folder / "changes.wpilog", "--rows-at", "Time", "-o", folder / "changes.bag")
            badlog("convert", log, "--rows-at", "Time", "-o", folder / "all.bag")
            contentOf(readRecording(folder / "changes.bag", LOG_FORMATS)) shouldBe contentOf(readRecording(folder / "all.bag", LOG_FORMATS))
        }
    }

    test("--only copies the records of matching topics, and their schemas") {
        inFolder { folder ->
            val log = folder.sampleLog("practice.bag")
            badlog("convert", log, "--only", "arm/*", "-o", folder / "arm.wpilog").code shouldBe ExitCode.WHOLE
            val wanted = readRecording(log, LOG_FORMATS).topics.filter { it.name.startsWith("Arm/") }
            val copied = readRecording(folder / "arm.wpilog", LOG_FORMATS).topics
            copied.map { it.name } shouldBe wanted.map { it.name }
            copied.map { it.samples.toList() } shouldBe wanted.map { it.samples.toList() }
        }
    }

    test("a WPILOG becomes rows of a period, 0.02 s without one, or of a topic's times") {
        inFolder { folder ->
            val log = folder.sampleLog("practice.bag")
            fun rows(vararg options: String): Int {
                badlog("convert", log, "-o", folder / "rows.csv", "--force", *options)
                return readRecording(folder / "rows.csv", LOG_FORMATS).also { it.format shouldBe RecordingFormat.CSV }.rowCount
            }
            rows("--period", "0.5") shouldBe 92
            rows() shouldBe 2270
            rows("--rows-at", "system/event log") shouldBe 6
            rows("--rows-at", "Time") shouldBe 2248
            leftOut(folder, log, "--to", "csv", "--rows-at", "Time") shouldContain "33 attributes"
            leftOut(folder, log, "--to", "csv", "--period", "0.5").first() shouldContain " samples lie between two rows and are left out (--rows-at, --period)"
        }
    }

    test("samples between the rows count as lost") {
        inFolder { folder ->
            folder.with("a.bag", "{\"topics\":[{\"name\":\"Time\",\"unit\":\"s\",\"attrs\":[\"xaxis\"]},{\"name\":\"y\"}]}\nTime,y\n0,1\n0.3,2\n0.31,3\n")
            badlog("convert", "--to", "wpilog", folder / "a.bag")
            fun ended(vararg options: String) = badlogJson("convert", folder / "a.wpilog", "-o", folder / "b.bag", "--force", *options)
            ended("--period", "1").run {
                code shouldBe ExitCode.SALVAGED
                json.single().getValue("status").jsonPrimitive.content shouldBe "salvaged"
            }
            ended("--rows-at", "Time").run {
                code shouldBe ExitCode.WHOLE
                json.single().getValue("status").jsonPrimitive.content shouldBe "whole"
            }
        }
    }

    test("NaN comes back, or is reported where it is written as an empty cell") {
        inFolder { folder ->
            val late = Logged("late", "double", "", listOf(0.5 to 1.0, 0.6 to Double.NaN))
            val log = folder.wpilog("a.wpilog", listOf(late, Logged("y", "double", "", listOf(0.0 to Double.NaN, 0.6 to 2.0))))
            leftOut(folder, log, "-o", folder / "b.bag", "--period", "0.1", "--force").filter { "NaN" in it } shouldContainExactly
                listOf("“late”: NaN is written as an empty cell.")
            readRecording(folder / "b.bag", LOG_FORMATS).topics.first { it.name == "y" }.counts.notFinite shouldBe 6
        }
    }

    test("no event between rows is lost, and events after the last row are reported") {
        inFolder { folder ->
            val bag = "{\"topics\":[{\"name\":\"Time\",\"unit\":\"s\",\"attrs\":[\"xaxis\"]},{\"name\":\"y\"},{\"name\":\"Log\",\"attrs\":[\"log\"]}]}\n" +
                "Time,y,Log\n0,1,\n0.3,2,a\n0.31,3,b\n0.5,4,c\n1,,d\n1.1,,e\n"
            folder.with("a.bag", bag)
            badlog("convert", "--to", "wpilog", folder / "a.bag")
            leftOut(folder, folder / "a.wpilog", "-o", folder / "b.bag", "--period", "1").first() shouldBe "6 samples lie between two rows and are left out (--rows-at, --period)"
            readRecording(folder / "b.bag", LOG_FORMATS).topics.last().texts.dictionary shouldContainExactly listOf("a; b; c; d", "e")
            leftOut(folder, folder / "a.wpilog", "-o", folder / "b.bag", "--rows-at", "y").first() shouldBe "2 samples lie between two rows and are left out (--rows-at, --period)"
        }
    }

    test("arguments that contradict each other are wrong usage") {
        inFolder { folder ->
            val log = folder.sampleLog("practice.bag")
            for (options in listOf(
                listOf("--to", "bag", "--period", "1", "--rows-at", "Time"),
                listOf("--to", "bag", "--period", "0"),
                listOf("--to", "wpilog", "--period", "1"),
                listOf("--to", "wpilog", "--x", "Time"),
                listOf("--to", "csv", "--changes-only"),
            )) {
                badlog("convert", log, *options.toTypedArray()).code shouldBe ExitCode.USAGE
            }
            badlog("convert", log, "--to", "bag", "--rows-at", "nix").err shouldContain "has no topic “nix” for --rows-at; its topics are"
            badlog("convert", log, "--to", "bag", "--period", "1e-9").err shouldContain "too many. Choose a longer --period."
            badlog("info", log, "--x", "Time").err shouldContain "whose x axis is always the time"
            folder.names().size shouldBe 1
        }
    }

    test("the rows of a WPILOG can have another topic as x axis") {
        inFolder { folder ->
            val log = folder.sampleLog("practice.bag")
            val json = badlogJson("convert", log, "--x", "System/Battery Voltage", "-o", folder / "a.bag").json.single()
            json.getValue("rows").jsonPrimitive.int shouldBe 2270
            readRecording(folder / "a.bag", LOG_FORMATS).topics.filter { "xaxis" in it.attributes }.map { it.name } shouldContainExactly listOf("System/Battery Voltage")
            readRecording(folder / "a.bag", LOG_FORMATS).problems.filter { it.severity.name == "ERROR" }.shouldBeEmpty()
        }
    }
})
