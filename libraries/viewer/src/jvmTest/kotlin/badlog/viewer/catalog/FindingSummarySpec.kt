package badlog.viewer.catalog

import badlog.core.analysis.Span
import badlog.core.recording.Severity
import badlog.rules.BUILT_IN_PROVEN
import badlog.rules.Finding
import badlog.rules.RuleSet
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class FindingSummarySpec : FunSpec({
    fun finding(rule: String, severity: Severity, from: Double, topic: String? = null, unit: String = "s", next: String = "") = Finding(rule, severity, topic, "$rule.", from, listOf(Span(from, from + 2)), 1, unit, next = next)

    fun verdict(vararg findings: Finding) = RuleSet.BUILT_IN_PROVEN.foundIn(findings.toList(), 7).verdict

    test("the verdict is the worst finding of the worst incident, with its time and its causes") {
        val cause = finding("Too much at once", Severity.WARNING, 92.0, "Total Current")
        val effects = listOf(finding("Low battery", Severity.ERROR, 92.9), finding("Browned out", Severity.ERROR, 93.7))
        val found = RuleSet.BUILT_IN_PROVEN.foundIn(listOf(finding("CAN errors", Severity.WARNING, 1.0), cause) + effects, 7)
        found.verdict!!.headline shouldBe "Browned out at 1:33"
        found.verdict.severity shouldBe Severity.ERROR
        found.verdict.sentences.first() shouldBe "Likely cause: the robot drew more than its battery gives. Too much at once."
        found.rules!!.map { it.name } shouldBe listOf("Browned out", "Low battery", "CAN errors", "Too much at once")
        found.key shouldBe 7
    }

    test("a finding outside all incidents is the verdict if it is worse than every incident") {
        val stalled = listOf("Drive/Left/Output", "Drive/Right/Output").map { finding("Encoder frozen", Severity.WARNING, 20.0, it) }
        val alone = finding("Team rule", Severity.ERROR, 5.0, next = "Ask Ada.")
        verdict(*stalled.toTypedArray(), alone) shouldBe Verdict(Severity.ERROR, "Team rule at 0:05", listOf("Team rule."), "Ask Ada.", errors = 1, warnings = 2)
    }

    test("the headline is in the sentences, and without incidents it is the first finding") {
        val heavy = listOf("Drive/Left/Output", "Drive/Right/Output").map { finding("Too much at once", Severity.WARNING, 90.0, it) }
        val chain = listOf("Low battery" to 91.0, "Browned out" to 91.5, "Main breaker" to 92.0).map { (rule, at) -> finding(rule, Severity.ERROR, at) }
        val found = verdict(*heavy.toTypedArray(), *chain.toTypedArray())!!
        found.sentences.any { found.headline.substringBefore(" at ") in it } shouldBe true
        verdict(finding("Late", Severity.ERROR, 80.0), finding("Early", Severity.ERROR, 5.0))!!.headline shouldBe "Early at 0:05"
    }

    test("a finding about the whole log has no time, and a time in another unit keeps its unit") {
        val whole = Finding("Weak battery", Severity.WARNING, null, "Weak.", Double.NaN, emptyList(), 1, "s")
        verdict(whole)!!.headline shouldBe "Weak battery"
        verdict(finding("Jump", Severity.WARNING, 12.0, unit = "m"))!!.headline shouldBe "Jump at 12 m"
    }

    test("notes alone, or nothing, are not a verdict") {
        verdict(finding("Note", Severity.NOTE, 3.0)) shouldBe null
        RuleSet.BUILT_IN_PROVEN.foundIn(emptyList(), 7) shouldBe FindingSummary(7, emptyList())
    }
})
