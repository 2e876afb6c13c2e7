package badlog.report

import badlog.core.analysis.Span
import badlog.core.python.HAS_PYTHON
import badlog.core.recording.Severity
import badlog.files.inFolder
import badlog.report.hook.HookOutcome
import badlog.report.hook.HookRunner
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import badlog.rules.RulesFile
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldEndWith
import kotlinx.serialization.json.jsonArray
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.exists

private fun rules(condition: String, text: String = "t", more: String = "", aliases: String = "") = RulesFile.parse(
    "[aliases]\n$aliases\n[[rule]]\nname = \"R\"\nseverity = \"warning\"\nwhen = \"$condition\"\ntext = \"$text\"\n$more\n",
).rules

private fun findings(folder: Path, rules: RuleSet) = Report(rules).over(logsIn(folder)).logs.flatMap { log -> log.findings.map { it.text } }

@Tags("InCheck")
class ReportSpec : FunSpec({
    test("placeholders in a rule's text are filled in") {
        inFolder { folder ->
            folder.put("Q1.bag", batteryBag(12.0, 6.0, 12.0, 6.5))
            val text = "{value}|{time}|{match}|{file}|{topic}|{count}|{duration}|{{x}}"
            findings(folder, rules("b < 7", text, aliases = "b = [\"*voltage\"]")) shouldContainExactly
                listOf("6 V|0.1 s|Mill Creek Qualification 1|Q1.bag|System/Battery Voltage|2|0.1 s|{x}")
        }
    }

    test("a condition about the whole recording holds once, from its start to its end") {
        inFolder { folder ->
            folder.put("1.bag", batteryBag(12.0, 6.0, 8.0))
            val text = "{value}|{time}|{count}|{duration}"
            findings(folder, rules("mean(Battery Voltage) < 9.5", text)) shouldContainExactly listOf("9 V|0 s|1|0.2 s")
            findings(folder, rules("min(Battery Voltage) < 9", text)) shouldContainExactly listOf("6 V|0.1 s|1|0.2 s")
        }
    }

    test("an alias finds its topic under any name, in any unit that can be converted") {
        val rules = rules("b < 7", "{value}", aliases = "b = { names = [\"none\", \"*volt*\"], unit = \"V\" }")
        inFolder { folder ->
            folder.put("1.bag", batteryBag(6000.0, name = "pdp/busVoltage", unit = "mV"))
            folder.put("2.bag", batteryBag(6.0, name = "VOLTS", unit = "ul"))
            folder.put("3.bag", batteryBag(6.0, name = "VOLTS", unit = "A"))
            findings(folder, rules) shouldContainExactly listOf("6 V", "6 V")
        }
    }

    test("a rule for each topic runs for topics with matching name, unit and kind") {
        inFolder { folder ->
            val currents = listOf("A/Current", "B/Current", "C/Current", "Limit Current", "Current State")
            val units = mapOf("B/Current" to "ul", "C/Current" to "V")
            val topics = mapOf("Time" to "s") + currents.associateWith { units[it] ?: "A" }
            folder.put("1.bag", bag(topics, listOf("0,50,10,50,50,on", "1,50,60,50,50,off")))
            val more = "each = [\"*current*\"]\nexcept = [\"limit*\"]\nunit = \"a\""
            findings(folder, rules("topic > 40", "{topic} {value}", more)) shouldContainExactly
                listOf("A/Current 50 A", "B/Current 60")
        }
    }

    test("the text of an event is its value") {
        inFolder { folder ->
            folder.put("1.bag", bag(mapOf("Time" to "s", "Log" to "ul"), listOf("0,", "1,CAN error", "2,")))
            findings(folder, rules("topic contains 'can'", "{time}: {value}", "each = [\"*\"]")) shouldContainExactly
                listOf("1 s: CAN error")
        }
    }

    test("time is the x axis, whatever it is called") {
        inFolder { folder ->
            folder.put("1.bag", bag(mapOf("Uptime" to "ms", "A" to "V"), listOf("0,1", "20,1", "900,1", "920,1")))
            findings(folder, rules("delta(time) > 0.5 s", "{value}")) shouldContainExactly listOf("880 ms")
        }
    }

    test("a clock that was set back is found") {
        inFolder { folder ->
            folder.put("1.bag", bag(mapOf("Time" to "s", "A" to "V"), listOf("10,1", "10.1,2", "5,3", "5.1,4")))
            Report().over(logsIn(folder)).logs.single().findings.map { it.text } shouldContainExactly listOf("The clock went back by 5.1 s.")
        }
    }

    test("a rule that needs time does not apply to a log that counts rows, and is not a mistake") {
        inFolder { folder ->
            folder.put("1.csv", "Current,b\n" + "80,1\n".repeat(20))
            val result = Report(rules("topic > 60 for 2 s", more = "each = [\"*current*\"]\nunit = \"A\"")).over(logsIn(folder))
            result.logs.single().findings.shouldBeEmpty()
            result.skipped.single().run {
                isMistake shouldBe false
                toString() shouldBe "The rule “R” was skipped for 1 log: the log has no x axis."
            }
        }
    }

    test("a rule counts only in matches of its types") {
        inFolder { folder ->
            folder.put("1.bag", batteryBag(6.0))
            val never = Report(rules("true", more = "only = [\"playoff\"]")).over(logsIn(folder))
            never.logs.single().findings.shouldBeEmpty()
            never.skipped.single().toString() shouldBe
                "The rule “R” was skipped for 1 log: it is only for matches of the type “playoff”."
            findings(folder, rules("true", more = "only = [\"playoff\", \"qualification\"]")) shouldContainExactly listOf("t")
        }
    }

    test("a rule with missing topics is reported once, and is not a mistake") {
        inFolder { folder ->
            for (i in 1..3) folder.put("$i.bag", batteryBag(6.0, name = "Other"))
            val rules = rules("b < 7", aliases = "b = [\"*voltage*\"]")
            Report(rules).over(logsIn(folder)).skipped.single().toString() shouldBe
                "The rule “R” was skipped for 3 logs: no topic for b, matching “*voltage*”."
            folder.put("4.bag", batteryBag(6.0, name = "Total Current"))
            Report(rules("Total Current > 5")).over(logsIn(folder)).run {
                skipped.single().isMistake shouldBe false
                skipped.single().logs shouldBe 3
                logs.sumOf { it.findings.size } shouldBe 1
            }
        }
    }

    test("a topic that may be misspelled is reported in a sentence with one period") {
        inFolder { folder ->
            // The first log has no similar topic.
            folder.put("1.bag", batteryBag(6.0, name = "Other"))
            folder.put("2.bag", batteryBag(6.0))
            Report(rules("Batery Voltage < 7")).over(logsIn(folder)).skipped.single().toString() shouldEndWith
                "Did you mean “System/Battery Voltage”?"
        }
    }

    test("a log with losses is reported, also from the cache, and a file that is not a log is reported as such") {
        inFolder { folder ->
            folder.put("logs/1.bag", batteryBag(6.0))
            folder.put("logs/2.bag", batteryBag(6.0) + "0.1,\n0.2,12,3\n")
            folder.put("logs/3.csv", "just some words\nand more of them\n")
            repeat(2) {
                val logs = Report(cache = folder.resolve("cache")).over(logsIn(folder.resolve("logs"))).logs
                logs.map { it.isSalvaged } shouldContainExactly listOf(false, true, false)
                logs.map { it.isNoLog } shouldContainExactly listOf(false, false, true)
            }
        }
    }

    test("a wrong expression is reported with its line in the file of rules") {
        inFolder { folder ->
            folder.put("1.bag", batteryBag(6.0))
            Report(rules("Battery Voltage < 7 A")).over(logsIn(folder)).skipped.single().run {
                isMistake shouldBe true
                message shouldContain "Line 6: “System/Battery Voltage” in V and 7 A have units that cannot be converted"
                message shouldContain "\nwhen = \"Battery Voltage < 7 A\"\n                          ^^^"
            }
            Report(rules("min(Battery Voltage)")).over(logsIn(folder)).skipped.single().message shouldContain "This is a number; compare it"
        }
    }

    test("the built-in rules have no mistakes, whatever topics the samples have") {
        Report().over(SAMPLES).run {
            skipped.none { it.isMistake } shouldBe true
            count(Severity.ERROR) shouldBe 4
        }
    }

    test("unchanged files are not read again, until the rules change") {
        inFolder { folder ->
            val cache = folder.resolve("cache")
            val file = folder.put("logs/1.bag", batteryBag(6.0))
            fun run(rules: RuleSet) = Report(rules, cache = cache).over(logsIn(folder.resolve("logs")))
            val text = reportText(run(RuleSet.BUILT_IN))
            spoil(file)
            reportText(run(RuleSet.BUILT_IN)) shouldBe text
            run(RulesFile.parse(RulesFile.BUILT_IN.source.replace("ms = 40", "ms = 41")).rules).logs.single().unreadable.isNullOrEmpty() shouldBe false
        }
    }

    test("rules may use virtual topics") {
        inFolder { folder ->
            folder.put("1.bag", batteryBag(6.0, 12.0))
            val report = Report(rules("max(Double) > 20", "{value}"), virtualTopics = listOf("Double [V] = Battery Voltage * 2"))
            report.over(logsIn(folder)).logs.single().findings.single().text shouldBe "24 V"
        }
    }

    test("with a listener for results, each log is two steps of progress") {
        inFolder { folder ->
            for (i in 1..3) folder.put("$i.bag", batteryBag(6.0))
            fun stepsOf(each: (() -> Unit)?): List<Pair<Int, Int>> {
                val steps = LinkedHashSet<Pair<Int, Int>>()
                Report(RuleSet.NONE).over(logsIn(folder), { done, total -> steps += done to total }, each?.let { { _, _ -> it() } })
                return steps.filter { it.first > 0 }
            }
            var taken = 0
            stepsOf { taken++ } shouldBe (1..6).map { it to 6 }
            taken shouldBe 3
            stepsOf(null) shouldBe (1..3).map { it to 3 }
        }
    }

    test("findings of hooks and rules are listed together, and the results of hooks are part of each log's result").config(enabled = HAS_PYTHON) {
        inFolder { folder ->
            folder.put("1.bag", batteryBag(6.0, 12.0))
            val answer = """{"values":{"a":1},"findings":[{"text":"odd","severity":"error","time":0.1,"until":0.2},{"text":"whole"}]}"""
            val hook = HookRunner(listOf("python3", "-c", "print('$answer')"), name = "odd finder")
            val outcomes = ArrayList<HookOutcome>()
            val result = Report(RuleSet.NONE, listOf(hook)).over(logsIn(folder)) { _, hooks -> outcomes += hooks }
            val (odd, whole) = result.logs.single().findings
            listOf(odd.rule, odd.text, odd.timeUnit) shouldBe listOf("odd finder", "odd", "s")
            odd.spans.single() shouldBe Span(0.1, 0.2)
            odd.isOfHook shouldBe true
            whole.time.isNaN() shouldBe true
            reportText(result) shouldContain "0.1 s  error    odd"
            reportCsv(result) shouldContain "odd finder,error,,odd,0.1,0.2,1,s"
            outcomes.single().result?.values shouldBe mapOf("a" to "1")
        }
    }

    test("a hook that fails is reported, and the findings of rules still count").config(enabled = HAS_PYTHON) {
        inFolder { folder ->
            folder.put("1.bag", batteryBag(6.0))
            val hook = HookRunner(listOf("python3", "-c", "import sys; sys.exit('no numpy')"), name = "h")
            val result = Report(rules("min(Battery Voltage) < 7"), listOf(hook)).over(logsIn(folder))
            result.logs.single().findings.size shouldBe 1
            reportText(result) shouldContain "1.bag, hook “h”: The hook ended with exit code 1; its last error: no numpy."
            jsonOf(ReportJson(result.logs.single())).getValue("hookFailures").jsonArray.size shouldBe 1
        }
    }

    test("the hooks in a file of rules only run on request").config(enabled = HAS_PYTHON) {
        inFolder { folder ->
            folder.put("1.bag", batteryBag(6.0))
            val file = RulesFile.parse("[[hook]]\ncommand = \"python3 -c 'open(\\\"ran\\\", \\\"w\\\")'\"\n")
            Report(file.rules).over(logsIn(folder))
            folder.resolve("ran").exists() shouldBe false
            Report(file.rules, file.hooks.map { HookRunner.of(it, folder) }).over(logsIn(folder))
            folder.resolve("ran").exists() shouldBe true
        }
    }

    test("a hook that fails in the same way in many logs is reported once") {
        inFolder { folder ->
            for (i in 1..5) folder.put("$i.bag", batteryBag(6.0))
            val text = reportText(Report(RuleSet.NONE, listOf(HookRunner(listOf("no-such-program"), name = "h"))).over(logsIn(folder)))
            text.lines().count { "hook “h”" in it } shouldBe 1
            text shouldContain "5 logs, hook “h”: "
        }
    }

    test("a hook that fails in many ways is reported with the first").config(enabled = HAS_PYTHON) {
        inFolder { folder ->
            for (i in 1..3) folder.put("$i.bag", batteryBag(6.0))
            val hook = HookRunner(listOf("python3", "-c", "import os, sys; sys.exit(str(os.getpid()))"), name = "h")
            val text = reportText(Report(RuleSet.NONE, listOf(hook)).over(logsIn(folder)))
            text.lines().single { "hook “h”" in it } shouldContain "3 logs, hook “h”, in the first, 1.bag: "
        }
    }

    test("the text is at most 100 characters wide where it can be") {
        inFolder { folder ->
            folder.put("${"n".repeat(240)}.bag", batteryBag(6.0))
            folder.put("photo.csv", "only words here\nand there\n")
            val text = reportText(Report(rules("true", "word ".repeat(100) + "x".repeat(300))).over(logsIn(folder)))
            text.lines().maxOf { it.length } shouldBeLessThanOrEqual 100
            text shouldContain "in 1 of 1 log."
        }
    }

    test("CSV is quoted by RFC 4180, and contains no formulas for a spreadsheet") {
        inFolder { folder ->
            folder.put("1.bag", bag(mapOf("Time" to "s", "=A,\"1\"" to "V"), listOf("0,1", "2.5,8")))
            folder.put("2.csv", "only words here\nand there\n")
            folder.put("3.bag", "gone")
            val files = logsIn(folder)
            Files.delete(folder.resolve("3.bag"))
            val csv = reportCsv(Report(rules("topic > 7", "=1+1, \\\"{value}\\\"", "each = [\"*\"]")).over(files))
            val lines = csv.split("\r\n")
            lines[0] shouldBe "file,match,rule,severity,topic,text,time,until,spans,time unit,incident,next"
            lines[1] shouldContain ",,R,warning,\"'=A,\"\"1\"\"\",\"'=1+1, \"\"8 V\"\"\",2.5,2.5,1,s,,"
            lines[2] shouldContain "3.bag,,unreadable,error,"
            lines.size shouldBe 4
        }
    }

    test("an unreadable log has the match of its file's name") {
        inFolder { folder ->
            folder.put("Q42.csv", "only words here\nand there\n")
            val log = Report(RuleSet.BUILT_IN).over(logsIn(folder)).logs.single()
            log.unreadable.isNullOrEmpty() shouldBe false
            log.match.match shouldBe "Qualification 42"
            log.matchType shouldBe "Qualification"
            log.title shouldBe null
        }
    }

    test("the JSON of a log has its findings and the skipped rules") {
        inFolder { folder ->
            folder.put("1.bag", batteryBag(6.0))
            folder.put("2.bag", batteryBag(12.0))
            folder.put("3.bag", batteryBag(12.0, name = "Volts"))
            val logs = Report(rules("min(Battery Voltage) < 7")).over(logsIn(folder)).logs.map { jsonOf(ReportJson(it)) }
            logs.map { it.getValue("findings").jsonArray.size } shouldContainExactly listOf(1, 0, 0)
            logs.map { it.getValue("notAsked").jsonArray.size } shouldContainExactly listOf(0, 0, 1)
        }
    }
})
