package badlog.rules.field

import badlog.core.recording.Severity
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.maps.shouldContainExactly
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain

private val LOW = Firing("0011223344556677", "Low battery", 93)

class FieldTableSpec : FunSpec({
    test("judgements are read with their remarks, and any other line is reported") {
        val text = "# of 2026\n${lineOf(LOW)}true\t6.7 V in the samples\n\n${lineOf(LOW.copy(rule = "Slow loops", second = null))}Unknown\n"
        judgementsIn(text) shouldContainExactly mapOf(LOW to Judgement.TRUE, LOW.copy(rule = "Slow loops", second = null) to Judgement.UNKNOWN)
        shouldThrow<IllegalArgumentException> { judgementsIn("#\n${lineOf(LOW)}perhaps\n") }.message shouldContain "Line 2 "
        shouldThrow<IllegalArgumentException> { judgementsIn("a\tb\tc\ttrue") }.message shouldContain "Line 1 "
    }

    test("each rule that could run has a row with its findings and judgements") {
        val found = listOf(FieldFinding(LOW, Severity.ERROR, "Low."), FieldFinding(LOW.copy(second = 120), Severity.ERROR, "Low."))
        val logs = listOf(FieldLog("a.wpilog", "254", setOf("Low battery"), found), FieldLog("b.wpilog", "254", setOf("Low battery", "Browned out"), emptyList()))
        val table = fieldTable(logs, mapOf(LOW to Judgement.FALSE))
        table shouldContain "| Low battery | 2 | 1 | 2 | 0 | 1 | 0 | 1 |"
        table shouldContain "| Browned out | 1 | 0 | 0 | 0 | 0 | 0 | 0 |"
        table.lines().count { it.startsWith("| ") } shouldBe 3
    }

    test("no rule could run over a log of a robot that was never enabled") {
        fun ran(enabled: Boolean) = fieldLogOf(
            (
                "{\"topics\":[{\"name\":\"Time\",\"unit\":\"s\",\"attrs\":[\"xaxis\"]},{\"name\":\"DS:enabled\",\"unit\":\"ul\",\"attrs\":[]}," +
                    "{\"name\":\"System/Battery Voltage\",\"unit\":\"V\",\"attrs\":[]}],\"values\":[]}\nTime,DS:enabled,System/Battery Voltage\n" +
                    (0..99).joinToString("") { "${it / 50.0},${enabled && it in 20..80},12.5\n" }
                ).encodeToByteArray(),
            "a.bag",
        ).shouldNotBeNull().ran
        ("Low battery" in ran(enabled = true)) shouldBe true
        ran(enabled = false) shouldBe emptySet()
    }

    test("a log is known by its bytes, and files that are not logs are left out") {
        val bag = "{\"topics\":[{\"name\":\"Time\",\"unit\":\"s\",\"attrs\":[\"xaxis\"]},{\"name\":\"System/Battery Voltage\",\"unit\":\"V\",\"attrs\":[]}],\"values\":[]}\n" +
            "Time,System/Battery Voltage\n" + (0..99).joinToString("") { "${it / 50.0},${if (it in 40..60) 6 else 12.5}\n" }
        val log = fieldLogOf(bag.encodeToByteArray(), "a.bag").shouldNotBeNull()
        log.findings.first { it.firing.rule == "Low battery" }.firing.let { (it.log.length to it.second) shouldBe (16 to 1L) }
        fieldLogOf(ByteArray(100) { 1 }, "b.bag").shouldBeNull()
    }
})
