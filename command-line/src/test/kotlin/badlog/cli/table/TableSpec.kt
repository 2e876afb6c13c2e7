package badlog.cli.table

import badlog.cli.BAG
import badlog.cli.Badlog
import badlog.cli.CUT_BAG
import badlog.cli.badlog
import badlog.cli.badlogJson
import badlog.cli.command.ExitCode
import badlog.cli.console.Console
import badlog.cli.console.ResultStream
import badlog.cli.with
import badlog.core.python.HAS_PYTHON
import badlog.files.inFolder
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import kotlinx.serialization.json.JsonPrimitive
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import java.io.ByteArrayOutputStream
import java.io.IOException
import java.io.OutputStream
import java.io.PrintStream
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.div
import kotlin.io.path.readText
import kotlin.io.path.writeText

@Tags("InCheck")
class TableSpec : FunSpec({
    fun Path.match(number: String, type: String = "Qualification") = with("$number.bag", BAG.replace("\"42\"", "\"$number\"").replace("}]}", "},{\"name\":\"Match Type\",\"value\":\"$type\"}]}"))

    fun table(vararg arguments: Any) = badlog("table", *arguments, "--no-cache")

    fun column(text: String, index: Int) = text.trimEnd().lines().drop(1).map { it.trim().split(Regex(" {2,}"))[index] }

    test("each log is a row, sorted by match numbers as numbers, those without one last") {
        inFolder { folder ->
            for (number in listOf("10", "9", "101", "2b", "final")) folder.match(number)
            val ended = table(folder, "--value", "max(Speed)", "--value", "count(Enabled) > 0", "--by", "match number")
            ended.code shouldBe ExitCode.WHOLE
            ended.err shouldBe "5 logs: 5 complete.\n"
            ended.out.lines()[0].trim().split(Regex(" {2,}")) shouldBe listOf("Match", "File", "match number", "max(Speed) (m/s)", "count(Enabled) > 0")
            column(ended.out, 2) shouldBe listOf("9", "10", "101", "2b", "final")
            column(ended.out, 3).distinct() shouldBe listOf("5.5")
            column(ended.out, 4).distinct() shouldBe listOf("yes")
        }
    }

    test("--only adds the lowest, mean and highest value of each matching topic, also for logs with different topics") {
        inFolder { folder ->
            folder.match("1")
            folder.match("2").let { it.writeText(it.readText().replace("Speed", "Arm/Speed")) }
            val lines = table(folder, "--only", "*speed", "--by", "Match Number", "--csv").out.trim().lines().map { it.trim() }
            lines[0] shouldBe "Match,File,Match Number," + listOf("Speed", "Arm/Speed").joinToString(",") { "min($it) (m/s),mean($it) (m/s),max($it) (m/s)" }
            val numbers = lines.drop(1).map { it.split(',').drop(3) }
            numbers.map { it[0] to it[2] } shouldBe listOf("1.5" to "5.5", "" to "")
            numbers.map { it[3] to it[5] } shouldBe listOf("" to "", "1.5" to "5.5")
            badlogJson("table", folder, "--only", "speed", "--no-cache").json[0].getValue("values").jsonObject.keys shouldBe
                setOf("min(Speed)", "mean(Speed)", "max(Speed)")
            table(folder, "--only", "Elevator/*").err shouldContain "No log has a topic that matches “Elevator/*”"
        }
    }

    test("CSV and JSON have exact numbers, and no value if it is unknown") {
        inFolder { folder ->
            folder.match("1").let { it.writeText(it.readText().replace("Enabled", "Height")) }
            folder.with("2.bag", "{\"topics\":[{\"name\":\"Speed\",\"unit\":\"m/s\"}],\"values\":[]}\nSpeed\n0.1\n")
            val csv = table(folder, "--value", "min(Speed)", "--value", "count(Height)", "--by", "Match Number", "--csv")
            csv.code shouldBe ExitCode.WHOLE
            csv.out.lines() shouldBe listOf(
                "Match,File,Match Number,min(Speed) (m/s),count(Height)",
                "Qualification 1,${folder / "1.bag"},1,1.5,1",
                ",${folder / "2.bag"},,0.1,",
                "",
            )
            val json = badlogJson("table", folder, "--value", "min(Speed)", "--value", "count(Height)", "--by", "Match Number", "--no-cache").json
            json.map { it.getValue("values").jsonObject.getValue("min(Speed)").jsonPrimitive.content } shouldBe listOf("1.5", "0.1")
            json[0].getValue("units").jsonObject.getValue("min(Speed)").jsonPrimitive.content shouldBe "m/s"
            json[0].getValue("by").jsonObject.getValue("Match Number").jsonPrimitive.content shouldBe "1"
            json[1].getValue("messages").jsonObject.getValue("count(Height)").jsonPrimitive.content shouldBe "“Height” is not a topic or signal of this log."
            table(folder, "--value", "min(Speed)", "--csv", "--json").code shouldBe ExitCode.USAGE
        }
    }

    test("only logs with header values that meet the condition are in the table") {
        inFolder { folder ->
            folder.match("1")
            folder.match("2", type = "Playoff")
            folder.with("3.bag", BAG)
            fun files(condition: String) = column(table(folder, "--value", "max(Speed)", "--where", condition).also { it.code shouldBe ExitCode.WHOLE }.out, 1)
            files("Match Type = 'Playoff'") shouldBe listOf("2.bag")
            files("Match Number > 1") shouldBe listOf("2.bag", "3.bag")
        }
    }

    test("a header value that no log has is reported with a similar one") {
        inFolder { folder ->
            folder.match("1")
            folder.match("2")
            val ended = table(folder, "--value", "max(Speed)", "--where", "Match Tpye = 'Playoff'")
            ended.code shouldBe ExitCode.USAGE
            ended.err shouldContain "“Match Tpye” is not a header value of this log. Did you mean “Match Type”?\nMatch Tpye = 'Playoff'\n^^^^^^^^^^"
            table(folder, "--value", "max(Speed)", "--where", "Match Type = Playoff").err shouldContain
                "“Playoff” is not a header value of this log; put a text in single quotes, as in 'Playoff'."
            badlog("find", folder, "max(Speed) where Even = 'x'", "--no-cache").err shouldContain "“Even” is not a header value"
            folder.with("3.bag", BAG.replace("Match Number", "Event"))
            badlog("find", folder, "max(Speed) where Event = 42", "--no-cache").out shouldContain "2 logs have no header value “Event”: 1.bag, 2.bag."
        }
    }

    test("a topic that no log has, and a mistake in a question or the condition, are pointed at") {
        inFolder { folder ->
            folder.match("1")
            val missing = table(folder, "--value", "max(Speed)", "--value", "max(Sped)")
            missing.code shouldBe ExitCode.USAGE
            missing.err shouldContain "“Sped” is not a topic or signal of this log. Did you mean “Speed”?\nmax(Sped)\n    ^^^^"
            missing.out shouldBe ""
            table(folder, "--value", "max(Speed").code shouldBe ExitCode.USAGE
            table(folder / "none", "--value", "max(Speed)", "--where", "Match Type = ").err shouldContain "^"
            table(folder).err shouldContain "Name a column: --value EXPRESSION, --only PATTERN or --hook COMMAND"
            val defined = table(folder, "--value", "max(Twice)", "--topic", "Twice = 2 * Sped")
            defined.code shouldBe ExitCode.USAGE
            defined.err shouldContain "Twice = 2 * Sped\n            ^^^^"
        }
    }

    test("damaged logs and other files are reported, and a folder without logs has the exit code for no result") {
        inFolder { folder ->
            val none = Files.createDirectories(folder / "none")
            val logs = folder / "logs"
            logs.match("1")
            logs.with("2.bag", CUT_BAG)
            logs.with("photo.gz", ByteArray(100) { 7 })
            val ended = table(logs, folder / "nix.bag", "--value", "max(Speed)")
            ended.code shouldBe ExitCode.SALVAGED
            column(ended.out, 1) shouldBe listOf("1.bag", "2.bag")
            ended.err shouldContain "Skipped ${logs / "photo.gz"}: This file is not a log"
            ended.err shouldContain "There is no file or folder ${folder / "nix.bag"}"
            val json = badlogJson("table", logs, folder / "nix.bag", "--value", "max(Speed)", "--no-cache")
            json.json.map { it.getValue("status").jsonPrimitive.content }.toSet() shouldBe setOf("whole", "salvaged", "skipped", "failed")
            table(none, "--value", "max(Speed)").run {
                code shouldBe ExitCode.NOTHING
                out shouldBe ""
                err shouldContain "No logs found."
            }
        }
    }

    test("a log may come from the standard input") {
        fun piped(input: String): Pair<ExitCode, String> {
            val out = ByteArrayOutputStream()
            val console = Console(PrintStream(out, true, "UTF-8"), PrintStream(OutputStream.nullOutputStream()), false)
            return Badlog(console, input.byteInputStream()).run(listOf("table", "-", "--value", "max(Speed)", "--csv", "--no-cache")) to out.toString(Charsets.UTF_8)
        }
        piped(BAG) shouldBe (ExitCode.WHOLE to "Match,File,max(Speed) (m/s)\r\nMatch 42,standard input,5.5\n")
        piped("There is nothing here\nbut words\n").first shouldBe ExitCode.NOTHING
    }

    test("a table that cannot be written is noticed") {
        inFolder { folder ->
            val full = object : OutputStream() {
                override fun write(byte: Int) = throw IOException("No space left on device")
            }
            val results = ResultStream(full)
            val console = Console(PrintStream(results), PrintStream(OutputStream.nullOutputStream()), false)
            Badlog(console).run(listOf("table", "${folder.match("1")}", "--value", "max(Speed)", "--no-cache"))
            results.failure?.message shouldBe "No space left on device"
        }
    }

    test("each value that a hook returns is a column").config(enabled = HAS_PYTHON) {
        inFolder { folder ->
            val logs = folder / "logs"
            logs.match("9")
            logs.match("10")
            val hook = folder.with("h.py", "import sys\nprint('{\"values\": {\"Rows\": %d, \"Verdict\": \"fine, so far\"}}' % (len(sys.stdin.readlines()) - 1))")
            val arguments = arrayOf<Any>(logs, "--hook", "python3 '$hook'", "--value", "max(Speed)", "--by", "Match Number")
            val ended = table(*arguments)
            ended.code shouldBe ExitCode.WHOLE
            ended.out.lines()[0] shouldContain "max(Speed) (m/s)  Rows  Verdict"
            column(ended.out, 4) shouldBe listOf("5", "5")
            table(*arguments, "--csv").out.lines()[1] shouldBe "Qualification 9,${logs / "9.bag"},9,5.5,5,\"fine, so far\""
            val json = badlogJson("table", *arguments, "--no-cache").json[0].getValue("hooks").jsonObject.getValue("h.py").jsonObject
            json.toMap() shouldBe mapOf("Rows" to JsonPrimitive(5.0), "Verdict" to JsonPrimitive("fine, so far"))
            // Alone, with the values of two hooks of the same name.
            val other = folder.with("i.py", "print('{\"values\": {\"Rows\": \"many\"}}')")
            val both = table(logs, "--hook", "python3 '$hook'", "--hook", "python3 '$other'")
            both.code shouldBe ExitCode.WHOLE
            both.out.lines()[0] shouldContain "Rows (h.py)  Verdict       Rows (i.py)"
        }
    }

    test("a hook that fails is reported once, and counts as left out") {
        inFolder { folder ->
            folder.match("1")
            folder.match("2")
            val ended = table(folder, "--hook", "no-such-program", "--value", "max(Speed)")
            ended.code shouldBe ExitCode.SALVAGED
            column(ended.out, 2) shouldBe listOf("5.5", "5.5")
            ended.err shouldContain "2 logs, hook “no-such-program”: The program “no-such-program” cannot be started"
            val json = badlogJson("table", folder, "--hook", "no-such-program", "--no-cache")
            json.code shouldBe ExitCode.SALVAGED
            json.json[0].getValue("hookFailures").jsonArray.size shouldBe 1
            table(folder, "--hook", "x", "--hook-seconds", "0").code shouldBe ExitCode.USAGE
            json.out shouldNotContain "exception"
        }
    }
})
