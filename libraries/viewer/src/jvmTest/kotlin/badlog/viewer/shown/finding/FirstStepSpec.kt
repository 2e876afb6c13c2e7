package badlog.viewer.shown.finding

import badlog.core.analysis.Span
import badlog.core.recording.Severity
import badlog.rules.BUILT_IN_PROVEN
import badlog.rules.Finding
import badlog.rules.RuleSet
import badlog.rules.incident.incidentsIn
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class FirstStepSpec : FunSpec({
    fun found(rule: String, time: Double, severity: Severity = Severity.WARNING) = Finding(rule, severity, "Arm/Output", rule, time, if (time.isNaN()) emptyList() else listOf(Span(time, time + 1)), 1, "s")

    fun stepOf(vararg findings: Finding) = firstStep(findings.toList(), RuleSet.BUILT_IN_PROVEN.incidentsIn(findings.toList()))

    fun FindingStep?.text() = this?.let { "${it.place.finding.rule} at ${it.place.span.from}${if (it.incident == null) "" else ", an incident"}" }

    val stalled = found("Encoder frozen", 20.0)
    val low = found("Low battery", 20.5)

    test("the first step goes to the start of the worst incident, or to a worse finding outside all incidents") {
        stepOf(low, stalled).text() shouldBe "Encoder frozen at 20.0, an incident"
        stepOf(low, stalled, found("Own rule", 90.0)).text() shouldBe "Encoder frozen at 20.0, an incident"
        stepOf(low, stalled, found("Own rule", 90.0, Severity.ERROR)).text() shouldBe "Own rule at 90.0"
    }

    test("an incident with a cause about the whole log leads to its first effect") {
        stepOf(found("High battery resistance", Double.NaN), found("Weak battery", 30.0)).text() shouldBe "Weak battery at 30.0, an incident"
    }

    test("without an incident, the first step is the worst finding, even one about the whole log, which has no place") {
        stepOf() shouldBe null
        stepOf(found("Note", 5.0, Severity.NOTE), found("Late", 8.0), found("Early", 6.0)).text() shouldBe "Early at 6.0"
        stepOf(found("Early", 6.0), found("Whole", Double.NaN)).text() shouldBe "Whole at NaN"
    }
})
