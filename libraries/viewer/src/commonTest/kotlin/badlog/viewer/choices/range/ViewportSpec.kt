package badlog.viewer.choices.range

import badlog.core.analysis.Span
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.doubles.shouldBeGreaterThanOrEqual
import io.kotest.matchers.doubles.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.double
import io.kotest.property.checkAll

class ViewportSpec : FunSpec({
    val whole = Viewport(Span(0.0, 100.0))

    test("a zoom keeps the place under the pointer") {
        whole.scaled(0.5, 20.0).visible shouldBe Span(10.0, 60.0)
    }

    test("for any request, the visible range stays within the recording and goes forward") {
        checkAll(Arb.double(), Arb.double(), Arb.double()) { from, to, factor ->
            val seen = whole.showing(from, to).scaled(factor, from).shifted(to).visible
            seen.from shouldBeGreaterThanOrEqual 0.0
            seen.to shouldBeLessThanOrEqual 100.0 + 1e-9
            (seen.width > 0) shouldBe true
        }
    }

    test("back returns through the previous ranges, and ends at the first") {
        val zoomed = whole.showing(10.0, 20.0).showing(30.0, 15.0)
        zoomed.visible shouldBe Span(15.0, 30.0)
        zoomed.back().visible shouldBe Span(10.0, 20.0)
        zoomed.back().back().visible shouldBe whole.full
        zoomed.back().back().back().visible shouldBe whole.full
    }

    test("all steps of one gesture are one step back") {
        val dragged = whole.remembered().moved(0.0, 50.0).moved(10.0, 60.0).moved(20.0, 70.0)
        dragged.back().visible shouldBe whole.full
    }

    test("an invisible place becomes visible, and a visible one moves nothing") {
        val zoomed = whole.showing(10.0, 20.0)
        zoomed.revealing(15.0) shouldBe zoomed
        zoomed.revealing(80.0).visible shouldBe Span(75.0, 85.0)
        zoomed.revealing(Double.NaN) shouldBe zoomed
    }

    test("when the recording grows, its end stays visible if it was") {
        whole.grown(Span(0.0, 110.0)).visible shouldBe Span(0.0, 110.0)
        whole.showing(90.0, 100.0).grown(Span(0.0, 110.0)).visible.from shouldBe (100.0 plusOrMinus 1e-9)
        whole.showing(10.0, 20.0).grown(Span(0.0, 110.0)).visible shouldBe Span(10.0, 20.0)
    }

    test("when the recording starts over and is shorter, the visible range stays within it") {
        whole.showing(50.0, 60.0).grown(Span(0.0, 30.0)).visible shouldBe Span(20.0, 30.0)
        whole.showing(50.0, 60.0).grown(Span(0.0, 5.0)).visible shouldBe Span(0.0, 5.0)
    }

    test("forward undoes back, until another range is shown") {
        val zoomed = whole.showing(10.0, 50.0).showing(20.0, 30.0)
        zoomed.back().back().forward().visible shouldBe Span(10.0, 50.0)
        zoomed.back().back().forward().forward() shouldBe zoomed
        zoomed.back().showing(1.0, 2.0).canGoForward shouldBe false
        zoomed.forward() shouldBe zoomed
    }

    test("a step zooms around a visible cursor, otherwise around the middle, and a step out undoes it") {
        whole.zoomed(1, 20.0).visible.from shouldBe (20.0 / 3 plusOrMinus 1e-9)
        whole.zoomed(1, Double.NaN).zoomed(-1, null).visible.width shouldBe (100.0 plusOrMinus 1e-9)
    }

    test("the visible range never becomes too narrow to draw, and a narrower recording cannot be zoomed") {
        var narrow = whole
        repeat(1000) { narrow = narrow.scaled(0.5, 50.0) }
        (narrow.visible.width > 0.0) shouldBe true
        for (full in listOf(Span(0.0, 2e-310), Span(1e15, 1e15 + 0.5))) {
            val zoomed = Viewport(full).showing(full.from, full.from + full.width / 2).scaled(0.5, full.from)
            (zoomed.visible.width <= full.width) shouldBe true
        }
    }

    test("a recording of one moment, or of none, can be shown") {
        (Viewport.of(7.0..7.0).visible.width > 0.0) shouldBe true
        Viewport.of(null).visible shouldBe Span(0.0, 1.0)
        Viewport.of(2.0..4.0).full shouldBe Span(2.0, 4.0)
    }
})
