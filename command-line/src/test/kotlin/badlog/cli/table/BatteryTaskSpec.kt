package badlog.cli.table

import badlog.cli.badlog
import badlog.cli.command.ExitCode
import badlog.cli.with
import badlog.files.inFolder
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlinx.serialization.json.Json
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import java.nio.file.Path

private const val TOPICS = """[{"name":"Time","unit":"s","attrs":["xaxis"]},{"name":"Battery Voltage","unit":"V","attrs":[]}]"""

class BatteryTaskSpec : FunSpec({
    fun Path.match(number: Int, battery: String?) {
        val named = if (battery == null) "" else ",{\"name\":\"Battery Name\",\"value\":\"$battery\"}"
        val values = "{\"name\":\"Match Number\",\"value\":\"$number\"},{\"name\":\"Match Type\",\"value\":\"Qualification\"}$named"
        val rows = (0..40).joinToString("") { "${it / 10.0},${12 - it / 100.0}\n" }
        with("$number.bag", "{\"topics\":$TOPICS,\"values\":[$values]}\nTime,Battery Voltage\n$rows")
    }

    fun table(vararg arguments: Any) = badlog("table", *arguments, "--no-cache")

    test("--by battery alone makes a row for each battery, as text, CSV and JSON") {
        inFolder { folder ->
            folder.match(1, "B2")
            folder.match(2, "A1")
            folder.match(3, "A1")
            folder.match(4, null)
            val text = table(folder, "--by", "battery")
            text.code shouldBe ExitCode.WHOLE
            text.out.lines().take(4).map { it.split(Regex(" {2,}")).take(2) } shouldBe
                listOf(listOf("Battery", "Matches"), listOf("A1", "2"), listOf("B2", "1"), listOf("Unknown", "1"))
            table(folder, "--by", "Battery", "--csv").out.lines()[1].take(5) shouldBe "A1,2,"
            val json = table(folder, "--by", "battery", "--json").out.trim().lines().map { Json.parseToJsonElement(it).jsonObject }
            json.map { it.getValue("battery").jsonPrimitive.content } shouldBe listOf("A1", "B2", "null")
        }
    }

    test("--by battery with a column shows the battery of each log") {
        inFolder { folder ->
            folder.match(1, "B2")
            folder.match(2, "A1")
            folder.match(3, null)
            folder.with("batteries.toml", "[used]\n\"Qualification 3\" = \"C3\"\n")
            val lines = table(folder, "--by", "battery", "--value", "max(battery)", "--csv").out.trim().lines()
            lines.map { it.split(',')[2] } shouldBe listOf("battery", "A1", "B2", "C3")
        }
    }

    test("where no log names its battery, the table says how to name one") {
        inFolder { folder ->
            folder.match(1, null)
            table(folder, "--by", "battery").err shouldContain "let it log a value “Battery Name”"
        }
    }

    test("unreadable logs are reported, and a condition needs a column") {
        inFolder { folder ->
            folder.with("notes.bag", "\u0000\u0001\u0002")
            table(folder, "--by", "battery").code shouldBe ExitCode.NOTHING
            folder.match(1, "A1")
            table(folder, "--by", "battery").code shouldBe ExitCode.SALVAGED
            table(folder, "--by", "battery", "--where", "'Match Number' = '1'").err shouldContain "need a column"
        }
    }
})
