package badlog.viewer.view

import badlog.analysis.Span
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

    test("a zoom leaves the place under the pointer where it stands") {
        whole.scaled(0.5, 20.0).visible shouldBe Span(10.0, 60.0)
    }

    test("whatever is asked for, what is seen stays within the recording and goes forward") {
        checkAll(Arb.double(), Arb.double(), Arb.double()) { from, to, factor ->
            val seen = whole.showing(from, to).scaled(factor, from).shifted(to).visible
            seen.from shouldBeGreaterThanOrEqual 0.0
            seen.to shouldBeLessThanOrEqual 100.0 + 1e-9
            (seen.width > 0) shouldBe true
        }
    }

    test("back returns through what was shown, and ends at the beginning") {
        val zoomed = whole.showing(10.0, 20.0).showing(30.0, 15.0)
        zoomed.visible shouldBe Span(15.0, 30.0)
        zoomed.back().visible shouldBe Span(10.0, 20.0)
        zoomed.back().back().visible shouldBe whole.full
        zoomed.back().back().back().visible shouldBe whole.full
    }

    test("the steps of one gesture are one step back") {
        val dragged = whole.remembered().moved(0.0, 50.0).moved(10.0, 60.0).moved(20.0, 70.0)
        dragged.back().visible shouldBe whole.full
    }

    test("a place out of sight is shown, one in sight moves nothing") {
        val zoomed = whole.showing(10.0, 20.0)
        zoomed.revealing(15.0) shouldBe zoomed
        zoomed.revealing(80.0).visible shouldBe Span(75.0, 85.0)
        zoomed.revealing(Double.NaN) shouldBe zoomed
    }

    test("when the recording grows, its end stays in sight where it was") {
        whole.grown(Span(0.0, 110.0)).visible shouldBe Span(0.0, 110.0)
        whole.showing(90.0, 100.0).grown(Span(0.0, 110.0)).visible.from shouldBe (100.0 plusOrMinus 1e-9)
        whole.showing(10.0, 20.0).grown(Span(0.0, 110.0)).visible shouldBe Span(10.0, 20.0)
    }

    test("when the recording begins anew and is shorter, what is seen stays within it") {
        whole.showing(50.0, 60.0).grown(Span(0.0, 30.0)).visible shouldBe Span(20.0, 30.0)
        whole.showing(50.0, 60.0).grown(Span(0.0, 5.0)).visible shouldBe Span(0.0, 5.0)
    }
})
