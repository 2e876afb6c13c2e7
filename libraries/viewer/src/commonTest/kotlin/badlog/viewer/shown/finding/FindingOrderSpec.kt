package badlog.viewer.shown.finding

import badlog.core.analysis.Span
import badlog.core.recording.Severity
import badlog.rules.Finding
import badlog.viewer.draw.mark.FindingTimeline
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class FindingOrderSpec : FunSpec({
    fun finding(rule: String, severity: Severity, vararg spans: Span) = Finding(rule, severity, null, rule, spans.firstOrNull()?.from ?: Double.NaN, spans.toList(), spans.size, "s", false, emptyList(), "")

    fun orderOf(all: List<Finding>) = FindingOrder(FindingTimeline(all, { it.severity }, { it.places }), emptyList())

    val late = finding("Late", Severity.NOTE, Span(81.0, 100.0))
    val whole = finding("Whole", Severity.ERROR)
    val early = finding("Early", Severity.ERROR, Span(21.0, 30.0), Span(60.0, 60.0))
    val middle = finding("Middle", Severity.WARNING, Span(51.0, 100.0))

    fun FindingStep?.text() = this?.let { "${it.place.finding.rule} ${it.place.span.from.toInt()}" }

    test("without incidents, steps go from the previous place, or otherwise the cursor, and stop at the ends") {
        val order = orderOf(listOf(late, whole, early, middle))
        fun step(steps: Int, from: Finding?, x: Double) = order.beside(from, x, steps).text()
        step(1, null, Double.NaN) shouldBe "Early 21"
        step(-1, null, Double.NaN) shouldBe "Late 81"
        step(1, early, 21.0) shouldBe "Middle 51"
        step(1, early, 60.0) shouldBe "Late 81"
        step(-1, early, 60.0) shouldBe "Middle 51"
        step(1, null, 40.0) shouldBe "Middle 51"
        step(-1, early, 40.0) shouldBe "Early 21"
        step(1, late, 81.0) shouldBe "Late 81"
        step(-1, null, 5.0) shouldBe "Early 21"
        orderOf(listOf(whole)).beside(null, 1.0, 1) shouldBe null
    }

    test("findings that begin at one instant are one step, to the worst of them") {
        val order = orderOf(listOf(late, finding("Twin", Severity.ERROR, Span(81.0, 82.0)), early))
        order.beside(early, 60.0, 1).text() shouldBe "Twin 81"
        order.beside(late, 81.0, -1).text() shouldBe "Early 60"
        order.beside(late, 81.0, 1).text() shouldBe "Twin 81"
    }
})
