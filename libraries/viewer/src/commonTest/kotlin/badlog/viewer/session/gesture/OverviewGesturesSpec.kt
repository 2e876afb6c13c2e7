package badlog.viewer.session.gesture

import badlog.core.analysis.Span
import badlog.viewer.input.OverviewGrip
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.shouldBe

class OverviewGesturesSpec : FunSpec({
    val part = Span(40.0, 60.0)

    test("an edge moves alone, and stops at the other one") {
        val plot = TestPlot(part)
        val gestures = OverviewGestures(plot)
        gestures.gripAt(pointer(400)) shouldBe OverviewGrip.LEFT
        gestures.stroke(pointer(400), pointer(350), pointer(300))
        plot.visible shouldBe Span(30.0, 60.0)
        gestures.stroke(pointer(600), pointer(100))
        plot.visible.from shouldBe (30.0 plusOrMinus 1e-3)
        (plot.visible.width < 1e-3) shouldBe true
    }

    test("the visible range moves as a whole, a drag beside it selects a new one, and one step back undoes each") {
        val plot = TestPlot(part)
        val gestures = OverviewGestures(plot)
        gestures.press(pointer(500))
        gestures.move(pointer(501))
        plot.visible shouldBe part
        gestures.move(pointer(600))
        gestures.move(pointer(700))
        plot.visible shouldBe Span(60.0, 80.0)
        gestures.release(pointer(700))
        plot.drag.shouldBeNull()
        plot.place.range.back().visible shouldBe part
        gestures.stroke(pointer(200), pointer(500))
        plot.visible shouldBe Span(20.0, 50.0)
        plot.place.range.back().visible shouldBe Span(60.0, 80.0)
    }

    test("a click beside the visible range moves it, a click inside does not, and both pin the cursor") {
        val plot = TestPlot(part)
        val gestures = OverviewGestures(plot)
        gestures.stroke(pointer(500))
        plot.visible shouldBe part
        plot.place.cursors.pinned shouldBe 50.0
        gestures.stroke(pointer(800, millis = 1000))
        plot.visible shouldBe Span(70.0, 90.0)
        plot.place.cursors.pinned shouldBe 80.0
    }

    test("a double click shows everything, and Escape undoes a drag") {
        val plot = TestPlot(part)
        val gestures = OverviewGestures(plot)
        gestures.press(pointer(500))
        gestures.move(pointer(700))
        gestures.giveUp()
        gestures.release(pointer(700))
        plot.visible shouldBe part
        gestures.stroke(pointer(200))
        gestures.stroke(pointer(202, millis = 100))
        plot.place.range.isZoomed shouldBe false
    }
})
