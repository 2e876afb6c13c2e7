package badlog.cli.info

import badlog.cli.BAG
import badlog.cli.Badlog
import badlog.cli.CUT_BAG
import badlog.cli.ROOT
import badlog.cli.SAMPLES
import badlog.cli.badlog
import badlog.cli.badlogJson
import badlog.cli.command.ExitCode
import badlog.cli.console.Console
import badlog.cli.text.jsonOf
import badlog.cli.topic.TopicChoice
import badlog.cli.with
import badlog.core.analysis.LogView
import badlog.core.recording.NumberSinks
import badlog.files.ReadOptions
import badlog.files.inFolder
import badlog.files.readRecording
import badlog.files.terminal.displayWidth
import badlog.formats.LOG_FORMATS
import badlog.report.NamedTopics
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import kotlinx.serialization.json.JsonNull
import kotlinx.serialization.json.JsonObject
import kotlinx.serialization.json.int
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import java.io.ByteArrayOutputStream
import java.io.OutputStream
import java.io.PrintStream
import kotlin.io.path.div
import kotlin.io.path.listDirectoryEntries

@Tags("InCheck")
class InfoSpec : FunSpec({
    test("tables fit terminals of 60 to 200 columns") {
        for (width in 60..200 step 5) {
            for (arguments in listOf(listOf("$SAMPLES"), listOf("$SAMPLES/qualification-42.bag", "--topics"), listOf("$SAMPLES/qualification-42.bag", "--signals"))) {
                val out = ByteArrayOutputStream()
                Badlog(Console(PrintStream(out, true, "UTF-8"), PrintStream(OutputStream.nullOutputStream()), false, width = width)).run(listOf("info") + arguments)
                val table = out.toString(Charsets.UTF_8).lines().dropWhile { line -> TITLES.none { it in line } }.takeWhile { it.isNotEmpty() }
                table.size shouldBeGreaterThan 4
                table.filter { displayWidth(it) > width }.shouldBeEmpty()
            }
        }
    }

    fun topic(json: JsonObject, name: String) = json.getValue("topics").jsonArray.first { it.jsonObject["name"]?.jsonPrimitive?.content == name }.jsonObject

    fun shown(width: Int, vararg arguments: String): String {
        val out = ByteArrayOutputStream()
        val console = Console(PrintStream(out, true, "UTF-8"), PrintStream(ByteArrayOutputStream()), false, width = width)
        Badlog(console).run(listOf("info") + arguments)
        return out.toString(Charsets.UTF_8)
    }

    test("every sample fits a terminal, in every form") {
        for (options in listOf(listOf(), listOf("--topics"), listOf("--attributes", "--values", "--problems"))) {
            for (log in listOf("practice.bag", "qualification-42.bag", "qualification-57.bag.gz", "elevator-bench.csv", "")) {
                val ended = badlog("info", SAMPLES / log, *options.toTypedArray())
                ended.err shouldBe if (log.isEmpty()) "5 logs: 3 complete, 2 incomplete.\n" else ""
                ended.out.lines().filter { it.length > 80 }.shouldBeEmpty()
            }
        }
    }

    test("a wider terminal shows more of long names, and another program all of them") {
        inFolder { folder ->
            val name = "Drive/Front Left/Steering Motor/Supply Current Measured"
            val log = folder.with("a.bag", BAG.replace("Speed", name))
            fun shown(width: Int) = shown(width, log.toString())
            shown(80) shouldNotContain name
            shown(140) shouldContain name
            shown(140).lines().filter { it.length > 140 }.shouldBeEmpty()
            shown(Console.UNLIMITED) shouldContain name
        }
    }

    test("another program gets one aligned line for each log, however long a name is") {
        inFolder { folder ->
            folder.with("a.bag", BAG)
            val long = folder.with("${"long ".repeat(20)}.bag", BAG)
            val lines = shown(Console.UNLIMITED, folder.toString()).trimEnd().lines()
            lines.size shouldBe 3
            lines.single { "$long" in it } shouldContain "Match 42"
            lines.drop(1).map { it.indexOf("Match 42") }.distinct() shouldBe listOf(lines[0].indexOf("MATCH"))
            lines.drop(1).map { it.length }.distinct().size shouldBe 1
            // A terminal shows each line as soon as the log is read.
            shown(80, folder.toString()).lines().first() shouldContain "LOG"
        }
    }

    test("signals fit a terminal, and another program gets all of their names") {
        inFolder { folder ->
            val name = "A Robot With Many Parts/Its Power Distribution/As It Was Measured/Battery Voltage"
            val log = folder.with("a.bag", BAG.replace("Speed", name).replace("m/s", "V"))
            fun shown(width: Int) = shown(width, "--signals", log.toString())
            shown(80) shouldContain "battery"
            shown(80) shouldNotContain name
            shown(80).lines().filter { it.length > 80 }.shouldBeEmpty()
            shown(Console.UNLIMITED) shouldContain name
        }
    }

    test("info shows a topic's count, rate, range and gaps") {
        inFolder { folder ->
            val json = badlogJson("info", folder.with("a.bag", BAG)).json.single()
            val speed = topic(json, "Speed")
            speed.getValue("count").jsonPrimitive.int shouldBe 4
            speed.getValue("min").jsonPrimitive.content shouldBe "1.5"
            speed.getValue("max").jsonPrimitive.content shouldBe "5.5"
            speed.getValue("gaps").jsonPrimitive.int shouldBe 1
            topic(json, "Time").getValue("rate").jsonPrimitive.content.toDouble() shouldBe 50.0
            topic(json, "Log").getValue("kind").jsonPrimitive.content shouldBe "event"
            topic(json, "Log").getValue("gaps") shouldBe JsonNull
            json.getValue("match").jsonPrimitive.content shouldBe "Match 42"
            json.getValue("x").jsonObject.getValue("to").jsonPrimitive.content shouldBe "0.08"
        }
    }

    test("info is the same with and without numbers in memory") {
        val folders = listOf(SAMPLES, ROOT / "core/conformance")
        for (file in folders.flatMap { it.listDirectoryEntries("*.{bag,csv,bag.gz}") }) {
            fun json(needed: NumberSinks): JsonObject {
                val numbers = StreamedNumbers(needed)
                val view = LogView.of(readRecording(file, LOG_FORMATS, ReadOptions(sinks = numbers)))
                return jsonOf(InfoJson(LogSummary(file, 0, view, numbers, TopicChoice(emptyList())), emptyList(), emptyList()))
            }
            json(NamedTopics(emptyList())) shouldBe json(NumberSinks.RECORDING)
        }
    }

    test("plain CSV has rates once its x axis is named, in any case of letters") {
        val json = badlogJson("info", SAMPLES / "elevator-bench.csv", "--x", "time").json.single()
        json.getValue("x").jsonObject.getValue("topic").jsonPrimitive.content shouldBe "Time"
        badlog("info", SAMPLES / "elevator-bench.csv", "--x", "nix").err shouldContain "elevator-bench.csv has no topic “nix”"
    }

    test("each problem is shown with its loss") {
        inFolder { folder ->
            val ended = badlogJson("info", folder.with("a.bag", CUT_BAG))
            ended.code shouldBe ExitCode.SALVAGED
            val cut = ended.json.single().getValue("problems").jsonArray.first().jsonObject
            cut.getValue("kind").jsonPrimitive.content shouldBe "ROW_CUT"
            cut.getValue("lost").jsonObject.getValue("rows").jsonPrimitive.int shouldBe 1
        }
    }

    test("JSON is plain ASCII, whatever the log holds") {
        inFolder { folder ->
            val ended = badlogJson("info", folder.with("a.bag", BAG.replace("Speed", "Größe \uD83E\uDD16")))
            ended.out.all { it.code < 0x7F } shouldBe true
            topic(ended.json.single(), "Größe \uD83E\uDD16").getValue("count").jsonPrimitive.int shouldBe 4
        }
    }

    test("control characters of a log do not reach the output") {
        inFolder { folder ->
            val hostile = BAG.replace("\"42\"", "\"4\\u001b[2J\\n2\"").replace("Speed", "Sp\u001b[31meed")
            badlog("info", folder.with("a.bag", hostile)).out shouldNotContain "\u001b"
        }
    }

    test("a topic that cannot be calculated for any of many logs is reported once") {
        inFolder { folder ->
            for (i in 1..4) folder.with("$i.bag", BAG)
            folder.with("5.bag", BAG.replace("Speed", "Sped"))
            badlog("info", folder, "--topic", "Odd = Sped").out shouldContain "“Odd = Sped” is not in 4 logs: “Sped” is not a topic"
        }
    }

    test("calculated topics are listed like others, and a mistake in a definition is pointed at") {
        inFolder { folder ->
            val log = folder.with("a.bag", BAG)
            val ended = badlog("info", log, "--topic", "Twice [m/s] = Speed * 2", "--topic", "Odd = Sped")
            ended.out shouldContain Regex("Twice +m/s +numeric +4 .* 3 … 11 ")
            ended.out shouldContain "Odd = Sped\n      ^^^^"
            val json = badlogJson("info", log, "--topic", "Twice [m/s] = Speed * 2", "--topic", "Odd = Sped").json.single()
            topic(json, "Twice").getValue("count").jsonPrimitive.int shouldBe 4
            json.getValue("undefined").jsonArray.size shouldBe 1
        }
    }

    test("--only shows the topics with matching names, also for several logs") {
        val shown = badlog("info", SAMPLES / "qualification-42.bag", "--only", "pdp/total*", "--only", "*battery voltage")
        shown.out shouldContain "PDP/Total Current"
        shown.out shouldContain "System/Battery Voltage"
        shown.out shouldNotContain "Drivetrain/"
        val both = badlog("info", SAMPLES / "qualification-42.bag", SAMPLES / "practice.bag", "--only", "arm/angle")
        both.out.lines().count { "Arm/Angle" in it } shouldBe 2
        badlog("info", SAMPLES / "qualification-42.bag", "--only", "arm/angle", "--json").json.single().getValue("topics").jsonArray.size shouldBe 1
    }
})

private val TITLES = listOf("SAMPLES", "COUNT", "WHY")
