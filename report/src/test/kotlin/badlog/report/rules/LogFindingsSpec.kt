package badlog.report.rules

import badlog.analysis.LogView
import badlog.bag.BagParser
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.shouldBe

class LogFindingsSpec : FunSpec({
    val header = """{"topics":[{"name":"Time","unit":"s","attrs":["xaxis"]},{"name":"Battery Voltage","unit":"V","attrs":[]}],"values":[]}"""
    val bag = "$header\nTime,Battery Voltage\n0,12\n1,6\n2,6\n3,12\n"
    val view = LogView.of(BagParser().apply { accept(bag.encodeToByteArray()) }.finish())

    test("a view that is read already is asked the rules, and those that do not fit it are told") {
        val result = RuleSet.DEFAULT.over(view, "test.bag")
        result.findings.map { it.rule } shouldContain "Low battery"
        result.skipped.map { it.rule } shouldContain "Loop overrun"
        result.skipped.none { it.isMistake } shouldBe true
    }

    test("a rule that is wrong is told as such, with its place") {
        val rules = RuleSet.parse("[[rule]]\nname = \"A\"\nseverity = \"note\"\nwhen = \"mean(Battery Voltage, 5) < 3\"\ntext = \"t\"\n")
        val skipped = rules.over(view, "test.bag").skipped.single()
        skipped.isMistake shouldBe true
        skipped.message.lines()[0].contains("4") shouldBe true
    }

    test("an interrupted thread stops asking") {
        Thread.currentThread().interrupt()
        shouldThrow<InterruptedException> { RuleSet.DEFAULT.over(view, "test.bag") }
        Thread.interrupted() shouldBe false
    }
})
