package badlog.cli.find

import badlog.cli.BAG
import badlog.cli.CUT_BAG
import badlog.cli.SAMPLES
import badlog.cli.badlog
import badlog.cli.badlogJson
import badlog.cli.command.ExitCode
import badlog.cli.with
import badlog.files.LogFile
import badlog.files.inFolder
import badlog.report.Find
import badlog.report.Reply
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import kotlinx.serialization.json.jsonPrimitive
import kotlin.io.path.div

private const val HEADER_OF_VOLTAGE = """{"topics":[{"name":"Time","unit":"s","attrs":["xaxis"]},{"name":"/SystemStats/BatteryVoltage","unit":"V"}],"values":[]}"""

class FindSpec : FunSpec({
    val samples = SAMPLES

    test("the matches in which it holds are reported with time and value") {
        val ended = badlog("find", samples, "min(System/Battery Voltage) < 7", "--no-cache")
        // Two of the samples are damaged.
        ended.code shouldBe ExitCode.SALVAGED
        ended.out shouldContain "93.7096 s  6.73 V"
        ended.out shouldContain "Found in 1 of 5 logs."
    }

    test("a mistake in the question is pointed at, and is a wrong usage") {
        val ended = badlog("find", samples / "practice.bag", "min(System/Battery Voltage) < ", "--no-cache")
        ended.code shouldBe ExitCode.USAGE
        ended.err shouldContain "^"
    }

    test("programs get JSON; a log that is missing counts as left out") {
        inFolder { folder ->
            val log = folder.with("a.bag", BAG)
            folder.with("sub/photo.gz", ByteArray(100) { 7 })
            folder.with("sub/b.bag", CUT_BAG.replace("Speed", "Größe"))
            val ended = badlogJson("find", log, folder / "nix.bag", folder / "sub", "max(Speed) > 5", "--no-cache")
            ended.code shouldBe ExitCode.SALVAGED
            ended.out.all { it.code < 0x7F } shouldBe true
            ended.json.map { it.getValue("command").jsonPrimitive.content }.distinct() shouldBe listOf("find")
            ended.json.map { it.getValue("status").jsonPrimitive.content } shouldBe listOf("whole", "failed", "salvaged", "skipped")
            ended.json[0].getValue("outcome").jsonPrimitive.content shouldBe "holds"
            ended.json[2].getValue("outcome").jsonPrimitive.content shouldBe "not_asked"
        }
    }

    test("the exit code is 0 if every log is whole, and other files are skipped with the reason") {
        inFolder { folder ->
            val log = folder.with("a.bag", BAG)
            badlog("find", log, log, "max(Speed) > 5", "--no-cache").code shouldBe ExitCode.WHOLE
            folder.with("photo.gz", ByteArray(100) { 7 })
            val ended = badlog("find", folder, "max(Speed) > 5", "--no-cache")
            ended.code shouldBe ExitCode.WHOLE
            ended.out shouldContain "Found in 1 of 1 log."
            ended.err shouldContain "Skipped ${folder / "photo.gz"}: This file is not a log"
            badlog("find", folder, folder / "nix.bag", "max(Speed) > 5", "--no-cache").code shouldBe ExitCode.SALVAGED
            folder.with("cut.bag", CUT_BAG)
            badlog("find", folder, "max(Speed) > 3", "--no-cache").code shouldBe ExitCode.SALVAGED
            badlog("find", folder / "nix.bag", "max(Speed) > 3", "--no-cache").code shouldBe ExitCode.NOTHING
        }
    }

    test("questions about plain CSV files may use the time") {
        val csv = samples / "elevator-bench.csv"
        badlog("find", csv, "Time > 1 for 1 s", "--x", "Time", "--no-cache").out shouldContain "Found in 1 of 1 log."
        badlog("find", csv, "Time >= 0 for 100 s", "--x", "Time", "--no-cache").out shouldContain "Found in 0 of 1 log."
        badlog("find", csv, "Time > 0", "--x", "Nix", "--no-cache").err shouldContain "elevator-bench.csv has no topic “Nix”"
    }

    test("a mistake in the question is reported without a log") {
        inFolder { folder -> badlog("find", folder, "min(Speed < 7", "--no-cache").code shouldBe ExitCode.USAGE }
    }

    test("a question may use topics that are calculated") {
        val power = "Power [W] = System/Battery Voltage * PDP/Total Current"
        val ended = badlog("find", samples, "max(Power) > 2000", "--topic", power, "--no-cache")
        ended.code shouldBe ExitCode.SALVAGED
        ended.out shouldContain "2708.3 W"
    }

    test("the hint is about the mistake, even if a log also lacks a topic") {
        // Only some samples have a topic State.
        val ended = badlog("find", samples, "State = SCORING", "--no-cache")
        ended.code shouldBe ExitCode.USAGE
        ended.err shouldContain "“SCORING” is not a topic or signal of this log; put a text in single quotes, as in 'SCORING'."
    }

    test("an answer that the log does not show is unknown, with the reason") {
        inFolder { folder ->
            folder.with("a.bag", BAG.replace("Enabled", "Other"))
            val ended = badlog("find", folder, "total(enabled)", "--no-cache")
            ended.out shouldContain "Found in 0 of 1 log."
            ended.out shouldContain "Unknown in 1 log: The log does not show when the robot was enabled."
        }
    }

    test("if a topic can be calculated for no log, the error points at its definition") {
        val ended = badlog("find", samples, "max(Power) > 2000", "--topic", "Power = Volage * 2", "--no-cache")
        ended.code shouldBe ExitCode.USAGE
        ended.err shouldContain "Power = Volage * 2\n        ^^^^^^"
    }

    test("for a misspelled signal, the signal and a similar topic are suggested") {
        inFolder { folder ->
            val bag = HEADER_OF_VOLTAGE + "\nTime,V\n0,12\n1,11\n"
            folder.with("a.bag", bag)
            badlog("find", folder, "max(battery voltge)", "--no-cache").run {
                code shouldBe ExitCode.USAGE
                err shouldContain "“battery voltge” is not a topic or signal of this log. Did you mean “/SystemStats/BatteryVoltage” or `battery`?\n" +
                    "max(battery voltge)\n    ^^^^^^^^^^^^^^"
            }
            badlog("find", folder, "min(batery)", "--no-cache").err shouldContain "Did you mean `battery`?"
            badlog("table", folder, "--value", "min(batery)", "--no-cache").err shouldContain "Did you mean `battery`?"
            badlog("find", folder, "max(battery voltage)", "--no-cache").code shouldBe ExitCode.WHOLE
        }
    }

    test("logs without a topic are named, at most three for each topic") {
        inFolder { folder ->
            folder.with("speed.bag", BAG)
            for (number in 1..5) folder.with("$number.bag", HEADER_OF_VOLTAGE + "\nTime,V\n0,12\n1,11\n")
            badlog("find", folder, "max(Speed)", "--no-cache").out shouldContain "5 logs have no topic “Speed”: 1.bag, 2.bag, 3.bag and 2 more."
            badlog("find", folder, "min(battery)", "--no-cache").out shouldContain "1 log has no topic “battery”: speed.bag."
        }
    }

    test("the number of implausible samples is reported, in text and JSON, also from the cache") {
        inFolder { folder ->
            val cells = "\nTime,V\n0,37.375\n1,12\n2,37.375\n3,11\n"
            for (name in listOf("a.bag", "b.bag")) folder.with(name, HEADER_OF_VOLTAGE + cells)
            folder.with("c.bag", HEADER_OF_VOLTAGE + cells.replace("37.375", "12"))
            badlog("find", folder, "max(battery)", "--no-cache").out shouldContain
                "Found in 3 of 3 logs.\nLeft out 4 samples of “/SystemStats/BatteryVoltage” in 2 logs: no robot has such values.\n"
            badlog("find", folder, "max(BatteryVoltage)", "--no-cache").out shouldNotContain "Left out"
            val json = badlogJson("find", folder, "max(battery)", "--no-cache").json
            json.map { it.getValue("implausible").toString() } shouldBe
                listOf("""[{"topic":"/SystemStats/BatteryVoltage","samples":2}]""", """[{"topic":"/SystemStats/BatteryVoltage","samples":2}]""", "[]")
            val find = { Find("max(battery)", cache = folder / "cache").over(listOf(LogFile.of(folder / "a.bag"))).single().reply as Reply.Answered }
            repeat(2) { find().implausible shouldBe listOf("/SystemStats/BatteryVoltage" to 2) }
        }
    }
})
