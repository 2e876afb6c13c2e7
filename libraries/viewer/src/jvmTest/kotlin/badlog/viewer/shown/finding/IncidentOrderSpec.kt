package badlog.viewer.shown.finding

import badlog.core.analysis.Span
import badlog.core.recording.Severity
import badlog.rules.BUILT_IN_PROVEN
import badlog.rules.Finding
import badlog.rules.RuleSet
import badlog.rules.incident.incidentsIn
import badlog.viewer.draw.mark.FindingTimeline
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class IncidentOrderSpec : FunSpec({
    fun found(rule: String, time: Double) = Finding(rule, Severity.WARNING, "Arm/Output", rule, time, listOf(Span(time, time + 1)), 1, "s")

    test("keys go through the incidents first, then through the other findings in the order of time, and back likewise") {
        val all = listOf(found("Own rule", 90.0), found("Low battery", 20.5), found("Encoder frozen", 20.0), found("Early rule", 5.0))
        val incidents = RuleSet.BUILT_IN_PROVEN.incidentsIn(all)
        val order = FindingOrder(FindingTimeline(all, { it.severity }, { it.places }), incidents)

        fun from(first: FindingStep?, steps: Int) = generateSequence(first) { order.beside(it.place.finding, it.place.span.from, steps) }.take(4).map { it.place.finding.rule }.toList()
        incidents.map { it.first.rule } shouldBe listOf("Encoder frozen")
        from(order.beside(null, Double.NaN, 1), 1) shouldBe listOf("Encoder frozen", "Early rule", "Own rule", "Own rule")
        from(order.beside(null, Double.NaN, -1), -1) shouldBe listOf("Own rule", "Early rule", "Encoder frozen", "Encoder frozen")
    }
})
