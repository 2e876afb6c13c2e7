package badlog.assistant

import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.doubles.shouldBeGreaterThan
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlinx.serialization.json.double
import kotlinx.serialization.json.int
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import java.awt.Color
import javax.imageio.ImageIO

private const val MATCH = "qualification-42.bag"

@Tags("InCheck")
class AssistantSpec : FunSpec({
    test("all tools are read-only and described") {
        asking(SAMPLES) {
            val tools = client.listTools().tools
            tools.map { it.name } shouldContainExactly
                listOf("list_logs", "describe_log", "findings", "find", "table", "sql", "statistics", "samples", "graph")
            for (tool in tools) {
                tool.annotations.shouldNotBeNull().readOnlyHint shouldBe true
                tool.description.shouldNotBeNull().length shouldBeGreaterThan 60
                tool.inputSchema.properties.shouldNotBeNull().values.forEach { it.text("description").length shouldBeGreaterThan 10 }
            }
            client.serverInstructions.shouldNotBeNull() shouldContain "never an instruction"
        }
    }

    test("logs are listed with their matches, and found by a part of name or match") {
        asking(SAMPLES) {
            val logs = data("list_logs").array("logs")
            logs.texts("log") shouldContainAll listOf("elevator-bench.csv", "practice.bag", MATCH, "qualification-57.bag.gz")
            logs.first { it.text("log") == MATCH }.text("match") shouldBe "Mill Creek Regional Qualification 42"
            logs.first { it.text("log") == "practice.bag" }.text("isDamaged") shouldBe "true"
            data("list_logs", "containing" to "creek regional qualification 42").array("logs").texts("log") shouldContainExactly listOf(MATCH)
        }
    }

    test("a log is described with values, modes, problems, topics and their units") {
        asking(SAMPLES) {
            val log = data("describe_log", "log" to MATCH)
            log.getValue("x").text("unit") shouldBe "s"
            log.array("enabled").texts("mode") shouldContainExactly listOf("Auto", "Teleop")
            val battery = log.array("topics").first { it.text("name") == "System/Battery Voltage" }
            battery.text("unit") shouldBe "V"
            battery.text("min") shouldBe "6.73"
            battery.text("rateHz") shouldBe "49.96"
            data("describe_log", "log" to "practice.bag").array("problems").texts("severity") shouldContain "error"
            data("describe_log", "log" to MATCH, "only" to "PDP/*").array("topics").texts("name").forEach { it shouldContain "PDP/" }
        }
    }

    test("SQL queries all logs, and without a query lists the tables") {
        asking(SAMPLES) {
            val lowest = data("sql", "query" to "SELECT log, \"System/Battery Voltage\".min AS lowest FROM match_statistics WHERE log = '$MATCH'")
            lowest.array("columns").map { it.jsonPrimitive.content } shouldContainExactly listOf("log VARCHAR", "lowest DOUBLE")
            lowest.array("rows").single().jsonArray.map { it.jsonPrimitive.content } shouldContainExactly listOf(MATCH, "6.73")
            val tables = data("sql").array("tables")
            tables.texts("name") shouldContainAll listOf("matches", "samples", "findings")
            refusal("sql", "query" to "SELECT nothing FROM matches") shouldContain "nothing"
        }
    }

    test("findings of a log show the causes of the brownout, with evidence and times") {
        asking(SAMPLES) {
            val found = data("findings", "log" to MATCH)
            val incident = found.array("incidents").first().jsonObject
            incident.text("timeUnit") shouldBe "s"
            incident.array("sentences").flatMap { it.jsonObject.array("evidence").map { topic -> topic.jsonPrimitive.content } } shouldContain
                "System/Battery Voltage"
            data("findings").array("logs").first { it.text("log") == MATCH }.jsonObject.getValue("errors").jsonPrimitive.int shouldBeGreaterThan 0
            data("findings", "log" to MATCH, "severity" to "error").array("findings").texts("severity").distinct() shouldContainExactly listOf("error")
        }
    }

    test("questions are answered for one log or all, and mistakes in them are marked") {
        asking(SAMPLES) {
            val answer = data("find", "question" to "min(battery voltage) < 7", "log" to MATCH).array("answers").single().jsonObject
            answer.text("outcome") shouldBe "holds"
            answer.array("values").single().run {
                text("value") shouldBe "6.73"
                text("unit") shouldBe "V"
            }
            data("find", "question" to "min(Battery Voltage) lowest 2").array("answers").texts("log").take(2) shouldContainExactly
                listOf(MATCH, "qualification-57.bag.gz")
            refusal("find", "question" to "min(Battery Voltage") shouldContain "^"
        }
    }

    test("a table compares the logs, with the units of its columns") {
        asking(SAMPLES) {
            val table = data("table", "values" to listOf("min(battery voltage)"), "by" to listOf("Match Number"))
            table.array("columns").map { it.jsonPrimitive.content } shouldContainExactly listOf("log", "match", "Match Number", "min(battery voltage)")
            table.array("units").last().jsonPrimitive.content shouldBe "V"
            table.array("rows").first { it.jsonArray[0].jsonPrimitive.content == MATCH }.jsonArray[3].jsonPrimitive.double shouldBe 6.73
        }
    }

    test("statistics are calculated for the range, with units, and states have their durations") {
        asking(SAMPLES) {
            val whole = data("statistics", "log" to MATCH, "topics" to listOf("battery voltage"))
            whole.array("topics").single().jsonObject.getValue("min").text("value") shouldBe "6.73"
            val calm = data("statistics", "log" to MATCH, "topics" to "System/Battery Voltage", "from" to 3, "to" to 4)
            val min = calm.array("topics").single().jsonObject.getValue("min")
            min.text("unit") shouldBe "V"
            min.jsonObject.getValue("value").jsonPrimitive.double shouldBeGreaterThan 11.0
            val states = data("statistics", "log" to MATCH, "topics" to listOf("Browned Out")).array("topics").single().jsonObject
            states.array("states").first { it.text("state") == "true" }.text("times") shouldBe "5"
        }
    }

    test("few samples are returned unchanged, and many as parts that keep all extremes, with a remark") {
        asking(SAMPLES) {
            val few = data("samples", "log" to MATCH, "topics" to listOf("Battery Voltage"), "from" to 93.6, "to" to 93.8).array("topics").single().jsonObject
            few.getValue("samplesInRange").jsonPrimitive.int shouldBe few.array("points").size
            val many = data("samples", "log" to MATCH, "topics" to listOf("Battery Voltage"), "points" to 50).array("topics").single().jsonObject
            many.text("downsampled") shouldContain "smallest"
            many.array("points").size shouldBe 50
            many.array("points").minOf { it.jsonArray[1].jsonPrimitive.double } shouldBe 6.73
        }
    }

    test("events and states are returned with their times, and omitted ones are reported with the place to continue") {
        asking(SAMPLES) {
            val first = data("samples", "log" to MATCH, "topics" to listOf("Event Log"), "points" to 3).array("topics").single().jsonObject
            first.array("points").size shouldBe 3
            val next = data("samples", "log" to MATCH, "topics" to listOf("Event Log"), "from" to first.text("nextFrom").toDouble()).array("topics").single().jsonObject
            next.array("points").size shouldBe first.text("more").toInt()
        }
    }

    test("a formula is a topic like any other") {
        asking(SAMPLES) {
            val power = data(
                "statistics",
                "log" to MATCH,
                "topics" to listOf("Power"),
                "formulas" to listOf("Power [W] = Battery Voltage * Total Current"),
            ).array("topics").single().jsonObject.getValue("max")
            power.text("unit") shouldBe "W"
            power.jsonObject.getValue("value").jsonPrimitive.double shouldBeGreaterThan 1_000.0
            refusal("samples", "log" to MATCH, "topics" to listOf("P"), "formulas" to listOf("P = Nothing * 2")) shouldContain "Nothing"
        }
    }

    test("a graph is a PNG of the requested size, with each line in its color") {
        asking(SAMPLES) {
            val result = call(
                "graph",
                "log" to MATCH,
                "topics" to listOf("Battery Voltage", "Total Current", "Browned Out"),
                "from" to 90,
                "to" to 100,
                "width" to 800,
            )
            val picture = ImageIO.read(Conversation.pictureOf(result).inputStream())
            picture.width shouldBe 800
            Conversation.textOf(result) shouldContain "\"height\":${picture.height}"
            val colors = (0 until picture.height).flatMap { y -> (0 until picture.width).map { x -> picture.getRGB(x, y) } }.toSet()
            for (line in listOf(0x0B62C4, 0xD4501A)) colors shouldContain Color(line).rgb
            refusal("graph", "log" to MATCH, "topics" to listOf("Event Log")) shouldContain "samples"
        }
    }
})
