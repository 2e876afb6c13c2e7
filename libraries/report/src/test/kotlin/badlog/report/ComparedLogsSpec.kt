package badlog.report

import badlog.exporter.HtmlExporter
import badlog.exporter.PageParts
import badlog.exporter.additionsIn
import badlog.files.inFolder
import badlog.report.page.ReportFolder
import badlog.report.page.reportPage
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import kotlinx.serialization.json.jsonObject
import java.nio.file.Path

/** A minute in which the robot drives, and its arm draws [amps] amperes. */
private fun match(number: Int, amps: Double, type: String = "Qualification", mode: String = "REAL"): String {
    val topics = mapOf("Time" to "s", "Enabled" to "ul", "Arm/Current" to "A", "Battery Voltage" to "V", "Total Current" to "A")
    val rows = List(600) { row ->
        val total = 30 + 30 * (row / 20 % 3)
        "${row / 10.0},${row > 20},${amps + row % 2},${12.5 - 0.015 * total - row % 5 * 0.01},$total"
    }
    return bag(topics, rows, mapOf("Event Name" to "Mill Creek", "Match Type" to type, "Match Number" to "$number", "RobotMode" to mode))
}

private fun Path.season(oddType: String = "Qualification"): Path = resolve("logs").also { logs ->
    for (number in 1..7) logs.put("Q$number.bag", match(number, 10.0 + number / 10.0))
    logs.put("Q8.bag", match(8, 21.0, oddType))
}

private const val FOUND = "Arm/Current while enabled was 21.5 A, 97 % above your 7 other matches (usually 10.9 A)."

class ComparedLogsSpec : FunSpec({
    fun compared(result: ReportResult) = result.logs.flatMap { log -> log.findings.filter { it.rule == "Unlike other matches" }.map { log.title to it.text } }

    test("a difference in one of eight matches is found, from the cache and by reading, also after a match was added") {
        inFolder { folder ->
            val logs = folder.season()
            fun run() = Report(cache = folder.resolve("cache")).over(logsIn(logs))
            compared(run()) shouldBe listOf("Mill Creek Qualification 8" to FOUND)
            spoil(logs.resolve("Q8.bag"))
            compared(run()) shouldBe listOf("Mill Creek Qualification 8" to FOUND)
            logs.put("Q9.bag", match(9, 11.0))
            compared(run()).single().second shouldContain "your 8 other matches"
        }
    }

    test("a simulation is neither compared nor compared with, and the text says which logs are simulations") {
        inFolder { folder ->
            val logs = folder.season()
            logs.put("Q8.bag", match(8, 21.0, mode = "SIM"))
            val result = Report().over(logsIn(logs))
            compared(result).shouldBeEmpty()
            reportText(result) shouldContain "1 log of a simulation: “Q8.bag”. Rules about power, wear and sensors did not run over it."
            for (number in 3..7) logs.put("Q$number.bag", match(number, 10.0, mode = "SIM"))
            logs.put("Q8.bag", match(8, 21.0))
            val others = Report().over(logsIn(logs))
            compared(others).shouldBeEmpty()
            reportText(others) shouldContain "5 logs of a simulation"
        }
    }

    test("a log that begins while the robot is enabled, after one of the same match that ended so, says that the code had restarted") {
        fun part(number: Int, enabled: (Int) -> Boolean) = bag(
            mapOf("Time" to "s", "Enabled" to "ul"),
            List(60) { row -> "${row / 10.0},${enabled(row)}" },
            mapOf("Event Name" to "Mill Creek", "Match Type" to "Qualification", "Match Number" to "$number"),
        )
        inFolder { folder ->
            val logs = folder.resolve("logs")
            logs.put("a.bag", part(1) { it > 20 })
            logs.put("b.bag", part(1) { it < 50 })
            logs.put("c.bag", part(2) { it < 50 })
            logs.put("d.bag", part(2) { it < 50 })
            repeat(2) {
                val result = Report(cache = folder.resolve("cache")).over(logsIn(logs))
                val found = result.logs.flatMap { log -> log.findings.filter { it.rule == "Restarted in the match" } }
                found.map { it.text } shouldBe
                    listOf("The log begins while the robot was enabled, and “a.bag”, of the same match, ended so: the robot code had restarted.")
                result.logs[1].incidents.first().name shouldBe "The robot code restarted during the match"
            }
        }
    }

    test("practice is not compared with matches") {
        inFolder { folder -> compared(Report().over(logsIn(folder.season("Practice")))).shouldBeEmpty() }
    }

    test("the resistance of the battery is listed with the match, in text and JSON") {
        inFolder { folder ->
            val result = Report().over(logsIn(folder.season()))
            reportText(result) shouldContain "Mill Creek Qualification 8 (Q8.bag), battery 15 ± 0."
            jsonOf(ReportJson(result.logs[0])).getValue("batteryResistance").jsonObject.keys shouldBe setOf("milliohms", "uncertainty")
        }
    }

    test("the page of a log has the findings that only a report has, and the index shows them for all matches") {
        inFolder { folder ->
            val logs = logsIn(folder.season())
            val pages = ReportFolder(folder.resolve("out"), logs, RuleSet.BUILT_IN, exporter = HtmlExporter(parts = PageParts("", "")))
            val result = Report().over(logs) { log, hooks -> pages.add(log, hooks) }
            additionsIn(folder.resolve("out/Q8.html")) shouldContain "97 % above your 7 other matches"
            additionsIn(folder.resolve("out/Q7.html")) shouldNotContain "other matches (usually"
            val index = reportPage(result)
            index shouldContain "aria-label=\"Arm/Current while enabled: 8 matches, from 10.6 A (Qualification 1) to 21.5 A (Qualification 8)"
            index shouldContain Regex("<title>Qualification 8: 21\\.5 A</title><path [^>]*fill=\"var\\(--error\\)\"")
            index shouldContain Regex("<title>Qualification 1: 10\\.6 A</title><path [^>]*fill=\"var\\(--accent\\)\"")
        }
    }
})
