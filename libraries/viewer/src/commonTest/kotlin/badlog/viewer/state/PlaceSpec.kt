package badlog.viewer.state

import badlog.core.analysis.Span
import badlog.viewer.choices.range.Viewport
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.double
import io.kotest.property.checkAll

class PlaceSpec : FunSpec({
    test("a moment outside the log becomes its nearer end, NaN and infinity change nothing, and a visible moment keeps the range") {
        val place = Place(Viewport(Span(0.0, 10.0)))
        place.at(1e308).cursors.pinned shouldBe 10.0
        place.at(-5.0).cursors.pinned shouldBe 0.0
        for (x in listOf(Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY)) place.at(x) shouldBe place
        for (x in listOf(1e308, -5.0, 3.0)) place.at(x).range shouldBe place.range
    }

    test("a person at the end of a growing log stays there despite rounding, and can go back") {
        checkAll(Arb.double(1.0, 1000.0, false), Arb.double(0.001, 0.9, false), Arb.double(0.01, 5.0, false)) { end, share, step ->
            var place = Place(Viewport(Span(0.0, end)).showing(end * share, end)).atEnd()
            repeat(20) {
                place.range.isAtEnd shouldBe true
                place = place.copy(range = place.range.grown(Span(0.0, place.range.full.to + step))).movedToEnd()
            }
            place.range.isAtEnd shouldBe true
            place.range.back().visible.from shouldBe (end * share plusOrMinus 1e-6)
        }
    }
})
