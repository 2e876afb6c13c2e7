package badlog.viewer.draw.figure

import badlog.core.analysis.Span
import badlog.core.recording.Severity
import badlog.rules.Finding
import badlog.viewer.draw.mark.Clocks
import badlog.viewer.draw.mark.FindingTimeline
import badlog.viewer.draw.mark.ModeTimeline
import badlog.viewer.shown.cursor.Cursors
import badlog.viewer.timedTopic
import badlog.viewer.timedView
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldStartWith

class FigureNotesSpec : FunSpec({
    val view = timedView(timedTopic("A", 0.0 to 1.0, 10.0 to 2.0))
    val clocks = Clocks(view, ModeTimeline.of(view))

    fun finding(rule: String, severity: Severity, vararg spans: Span, texts: List<String> = emptyList()) = Finding(rule, severity, null, "all of it", spans.firstOrNull()?.from ?: Double.NaN, spans.toList(), spans.size, "s", texts = texts)

    fun notes(visible: Span, cursors: Cursors, vararg found: Finding) = FigureNotes.of("a.bag", view.xAxis, visible, cursors, clocks, FindingTimeline(found.toList(), { it.severity }, { it.places }))

    test("the notes name the file, its visible range, and the places of the cursors") {
        notes(Span(2.0, 12.0), Cursors()).place shouldBe "a.bag · 2.000 – 12.000 s"
        notes(Span(2.0, 12.0), Cursors(pinned = 3.0)).place shouldBe "a.bag · 2.000 – 12.000 s · cursor at 3.000 s"
        notes(Span(2.0, 12.0), Cursors(pinned = 3.0, second = 5.5)).place shouldStartWith
            "a.bag · 2.000 – 12.000 s · cursor at 3.000 s · B at 5.500 s, Δ 2.5"
    }

    test("the notes name the findings in the visible range, the worst first, with their values there") {
        val found = notes(
            Span(2.0, 12.0),
            Cursors(),
            finding("Before", Severity.ERROR, Span(0.0, 1.0)),
            finding("Lasting", Severity.WARNING, Span(1.0, 9.0)),
            finding("Again", Severity.ERROR, Span(0.0, 0.5), Span(4.0, 4.5), texts = listOf("first", "second")),
            finding("Whole", Severity.ERROR),
        ).findings
        found.map { it.head + " " + it.text } shouldBe listOf("error · 4.000 s Again: second", "warning · 1.000 s Lasting: all of it")
    }

    test("many findings are named in part, and the rest is counted") {
        val many = notes(Span(0.0, 10.0), Cursors(), *Array(11) { finding("Rule $it", Severity.NOTE, Span(1.0, 2.0)) })
        many.findings.size shouldBe FigureNotes.MAX_NAMED
        many.moreFindings shouldBe 3
    }
})
