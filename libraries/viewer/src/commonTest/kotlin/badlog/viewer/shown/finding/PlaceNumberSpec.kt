package badlog.viewer.shown.finding

import badlog.core.analysis.Span
import badlog.core.recording.Severity
import badlog.rules.Finding
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class PlaceNumberSpec : FunSpec({
    val spans = listOf(Span(2.0, 2.5), Span(1.0, 1.5), Span(3.0, 3.5))

    fun found(count: Int) = Finding("Stalled", Severity.ERROR, null, "It stalled.", 2.0, spans, count, "s")

    test("a place has its number among all places, in the order of x") {
        found(3).placeNumber(Span(2.0, 2.5)) shouldBe "2 of 3"
        found(3).placeNumber(Span(7.0, 7.0)) shouldBe "1 of 3"
    }

    test("a finding with more occurrences than known places shows both numbers") {
        found(1200).placeNumber(Span(3.0, 3.5)) shouldBe "3 of 3, found 1200 times"
    }
})
