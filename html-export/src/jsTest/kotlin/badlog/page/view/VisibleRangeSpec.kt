package badlog.page.view

import badlog.analysis.Span
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class VisibleRangeSpec : FunSpec({
    fun span(from: Double, to: Double) = Span(from, to)

    test("keeps within the recording, and its width where it can") {
        val range = VisibleRange(0.0, 100.0)
        range.show(90.0, 120.0)
        range.now shouldBe span(70.0, 100.0)
        range.show(40.0, 20.0)
        range.now shouldBe span(20.0, 40.0)
        range.show(-500.0, 500.0)
        range.isZoomed shouldBe false
    }

    test("goes back through what was shown") {
        val range = VisibleRange(0.0, 100.0)
        range.show(10.0, 50.0)
        range.show(20.0, 30.0)
        range.back()
        range.now shouldBe span(10.0, 50.0)
        range.reset()
        range.back()
        range.now shouldBe span(10.0, 50.0)
        range.back()
        range.now shouldBe span(0.0, 100.0)
        range.canGoBack shouldBe false
    }

    test("zooms around a place that stays where it is") {
        val range = VisibleRange(0.0, 100.0)
        range.scale(0.5, 25.0)
        range.now shouldBe span(12.5, 62.5)
    }

    test("never becomes too narrow to draw") {
        val range = VisibleRange(0.0, 100.0)
        repeat(1000) { range.scale(0.5, 50.0) }
        (range.now.width > 0.0) shouldBe true
    }

    test("a recording that is narrower than what can be drawn cannot be zoomed, and nothing fails") {
        for ((from, to) in listOf(0.0 to 2e-310, 1e15 to 1e15 + 0.5)) {
            val range = VisibleRange(from, to)
            range.show(from, from + (to - from) / 2)
            range.scale(0.5, from)
            (range.now.width <= range.full.width) shouldBe true
        }
    }

    test("a recording of one moment, or of none, can be shown") {
        (VisibleRange(7.0, 7.0).now.width > 0.0) shouldBe true
        VisibleRange(Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY).now.width shouldBe 1.0
    }
})
