package badlog.viewer.session.gesture

import badlog.core.analysis.Span
import badlog.viewer.input.DragKind
import badlog.viewer.input.PointerButton
import badlog.viewer.shown.cursor.Cursors
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.boolean
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.triple
import io.kotest.property.checkAll

class PlotGesturesSpec : FunSpec({
    fun over(plot: TestPlot, isAxis: Boolean = false) = PlotGestures(plot, isAxis)

    test("a drag shows the dragged range, in either direction, limited to the frame") {
        for (places in listOf(listOf(200, 400), listOf(400, 200))) {
            val plot = TestPlot()
            over(plot).stroke(pointer(places[0]), pointer(300), pointer(places[1]))
            plot.visible shouldBe Span(20.0, 40.0)
            plot.drag.shouldBeNull()
            plot.place.range.back().visible shouldBe Span(0.0, 100.0)
        }
        val plot = TestPlot()
        over(plot).stroke(pointer(800), pointer(900), pointer(1200))
        plot.visible shouldBe Span(80.0, 100.0)
    }

    test("a drag shows its range, moves the cursor, and zooms nothing until its end") {
        val plot = TestPlot()
        val gestures = over(plot)
        gestures.press(pointer(200))
        gestures.isActive shouldBe true
        gestures.move(pointer(202))
        plot.drag.shouldBeNull()
        gestures.move(pointer(300))
        plot.drag?.xSpan shouldBe Span(20.0, 30.0)
        plot.place.cursors.hover shouldBe 30.0
        plot.place.range.isZoomed shouldBe false
    }

    test("a vertical drag over a graph neither zooms nor clicks") {
        val plot = TestPlot()
        over(plot).stroke(pointer(200, y = 20), pointer(202, y = 90))
        plot.place.range.isZoomed shouldBe false
        plot.place.cursors.pinned.shouldBeNull()
    }

    test("the touched place stays under a panning pointer, also after the end of the log, and one step back undoes the drag") {
        val plot = TestPlot(Span(10.0, 30.0))
        val gestures = over(plot)
        gestures.press(pointer(500, shift = true))
        gestures.move(pointer(1200))
        plot.visible.from shouldBe (0.0 plusOrMinus 1e-9)
        gestures.move(pointer(750))
        plot.visible.from shouldBe (5.0 plusOrMinus 1e-9)
        gestures.release(pointer(500))
        plot.place.range.back().visible shouldBe Span(10.0, 30.0)
    }

    test("the middle button pans, and over the axis a plain drag does") {
        val plot = TestPlot(Span(40.0, 60.0))
        over(plot).stroke(pointer(500, button = PointerButton.MIDDLE), pointer(250, button = PointerButton.MIDDLE))
        plot.visible shouldBe Span(45.0, 65.0)
        over(plot, isAxis = true).stroke(pointer(250), pointer(500))
        plot.visible shouldBe Span(40.0, 60.0)
    }

    test("a drag with Alt selects a part of y within the lines, and without lines zooms x") {
        val plot = TestPlot(lineShare = 0.5)
        over(plot).stroke(pointer(500, y = 25, alt = true), pointer(500, y = 40), pointer(500, y = 80))
        plot.parts shouldBe listOf(Span(0.5, 1.0))
        plot.place.range.isZoomed shouldBe false
        val lanes = TestPlot(lineShare = 0.0)
        over(lanes).stroke(pointer(200, alt = true), pointer(400))
        lanes.parts shouldBe emptyList()
        lanes.visible shouldBe Span(20.0, 40.0)
    }

    test("the right button and Ctrl select a range, and do nothing without a drag") {
        for ((ctrl, button) in listOf(true to PointerButton.LEFT, false to PointerButton.RIGHT)) {
            val plot = TestPlot()
            val gestures = over(plot)
            gestures.stroke(pointer(500, ctrl = ctrl, button = button), pointer(600))
            plot.place.selection shouldBe Span(50.0, 60.0)
            gestures.stroke(pointer(700, ctrl = ctrl, button = button))
            plot.place.selection shouldBe Span(50.0, 60.0)
            plot.place.cursors.pinned.shouldBeNull()
            plot.place.range.isZoomed shouldBe false
        }
    }

    test("the cursor follows the pointer until a click pins it, and again after another click on it") {
        val plot = TestPlot()
        val gestures = over(plot)
        gestures.move(pointer(300))
        plot.place.cursors.x shouldBe 30.0
        gestures.stroke(pointer(300))
        gestures.move(pointer(800))
        plot.place.cursors.x shouldBe 30.0
        plot.place.range shouldBe TestPlot().place.range
        gestures.leave()
        plot.place.cursors.hover.shouldBeNull()
        gestures.stroke(pointer(304, millis = 1000))
        gestures.move(pointer(800))
        plot.place.cursors.x shouldBe 80.0
    }

    test("a click with Shift sets a second cursor, also as the second of two quick clicks") {
        val plot = TestPlot()
        val gestures = over(plot)
        gestures.stroke(pointer(300))
        gestures.stroke(pointer(305, millis = 100, shift = true))
        gestures.move(pointer(800))
        plot.place.cursors shouldBe Cursors(pinned = 30.0, second = 30.5, hover = 80.0)
    }

    test("the pointer does not disturb a cursor that playback moves, but a click pins it") {
        val plot = TestPlot()
        plot.isCursorLed = true
        val gestures = over(plot)
        gestures.move(pointer(300))
        plot.place.cursors.hover.shouldBeNull()
        gestures.stroke(pointer(300))
        plot.place.cursors.pinned shouldBe 30.0
    }

    test("a double click shows everything, and its first click has no effect") {
        val plot = TestPlot(Span(20.0, 40.0))
        plot.place = plot.place.copy(cursors = Cursors(pinned = 25.0))
        val gestures = over(plot)
        gestures.stroke(pointer(500))
        plot.place.cursors.pinned shouldBe 30.0
        gestures.stroke(pointer(502, millis = 200))
        plot.visible shouldBe Span(0.0, 100.0)
        plot.parts shouldBe listOf(null)
        plot.place.cursors.pinned shouldBe 25.0
    }

    test("two quick clicks or taps far apart are not a double click: each moves the cursor, and the range stays") {
        for (finger in listOf(null, 1)) {
            val plot = TestPlot(Span(20.0, 40.0))
            val gestures = over(plot)
            gestures.stroke(pointer(800, finger = finger))
            plot.place.cursors.pinned shouldBe 36.0
            gestures.stroke(pointer(100, millis = 100, finger = finger))
            plot.place.cursors.pinned shouldBe 22.0
            plot.visible shouldBe Span(20.0, 40.0)
            plot.parts shouldBe emptyList()
        }
    }

    test("Escape undoes a panning drag, and cancels a zooming one, and its release does nothing") {
        for (shift in listOf(true, false)) {
            val plot = TestPlot(Span(20.0, 40.0))
            val before = plot.place.range
            val gestures = over(plot)
            gestures.press(pointer(500, shift = shift))
            gestures.move(pointer(700))
            plot.drag?.kind shouldBe if (shift) DragKind.PAN else DragKind.ZOOM
            gestures.giveUp()
            gestures.isActive shouldBe false
            gestures.release(pointer(800))
            plot.place.range shouldBe before
            plot.drag.shouldBeNull()
            plot.place.cursors.pinned.shouldBeNull()
        }
    }

    test("a drag that its display has cancelled has no further effect") {
        val plot = TestPlot(Span(20.0, 40.0))
        val gestures = over(plot)
        gestures.press(pointer(500))
        gestures.move(pointer(700))
        plot.drag = null
        gestures.move(pointer(750))
        gestures.release(pointer(800))
        plot.visible shouldBe Span(20.0, 40.0)
        plot.drag.shouldBeNull()
    }

    test("a finger zooms to the dragged range, and moves a zoomed graph, as on a map") {
        val plot = TestPlot()
        val gestures = over(plot)
        gestures.stroke(pointer(200, finger = 1), pointer(400, finger = 1))
        plot.visible shouldBe Span(20.0, 40.0)
        gestures.stroke(pointer(500, finger = 1), pointer(250, finger = 1))
        plot.visible shouldBe Span(25.0, 45.0)
    }

    test("two fingers zoom around their middle, in one step, and lifting them is not a tap") {
        val plot = TestPlot()
        val gestures = over(plot)
        gestures.press(pointer(400, finger = 1))
        gestures.press(pointer(600, finger = 2))
        for (step in 1..10) {
            gestures.move(pointer(400 - 20 * step, finger = 1))
            gestures.move(pointer(600 + 20 * step, finger = 2))
        }
        gestures.release(pointer(200, finger = 1))
        gestures.move(pointer(0, finger = 2))
        gestures.release(pointer(0, finger = 2))
        plot.visible.from shouldBe (100.0 / 3 plusOrMinus 1e-6)
        plot.visible.to shouldBe (200.0 / 3 plusOrMinus 1e-6)
        plot.place.cursors.pinned.shouldBeNull()
        plot.place.range.back().visible shouldBe Span(0.0, 100.0)
        gestures.stroke(pointer(500, finger = 3))
        plot.place.cursors.pinned.shouldNotBeNull() shouldBe (50.0 plusOrMinus 1e-6)
    }

    test("a resting finger is a click with Shift, with a finger's reach, unless it moves or another one is down") {
        val plot = TestPlot()
        val gestures = over(plot)
        gestures.stroke(pointer(300, finger = 1))
        gestures.press(pointer(700, millis = 1000, finger = 1))
        gestures.rest()
        gestures.release(pointer(700, finger = 1))
        plot.place.cursors.second shouldBe 70.0
        gestures.press(pointer(712, millis = 2000, finger = 1))
        gestures.rest()
        gestures.release(pointer(712, finger = 1))
        plot.place.cursors shouldBe Cursors(pinned = 30.0)
        gestures.press(pointer(100, millis = 3000, finger = 1))
        gestures.move(pointer(200, finger = 1))
        gestures.rest()
        gestures.cancel(pointer(200, finger = 1))
        gestures.rest()
        plot.place.cursors.second.shouldBeNull()
        plot.place.range.isZoomed shouldBe false
    }

    test("the wheel with Ctrl zooms around the pointer, and alone scrolls the page") {
        val plot = TestPlot()
        val gestures = over(plot)
        gestures.wheel(pointer(250), 0.0, -60.0) shouldBe false
        gestures.wheel(pointer(250, ctrl = true), 0.0, -60.0) shouldBe true
        (25.0 - plot.visible.from) / plot.visible.width shouldBe (0.25 plusOrMinus 1e-9)
    }

    test("after any gestures, nothing is dragged without a pressed pointer, and the range stays within the log") {
        checkAll(Arb.list(Arb.triple(Arb.int(0..5), Arb.int(-200..1200), Arb.boolean()), 0..40)) { events ->
            val plot = TestPlot(Span(30.0, 60.0))
            val gestures = over(plot)
            val down = HashSet<Int?>()
            for ((what, x, isTouch) in events) {
                val finger = if (isTouch) x and 1 else null
                val at = pointer(x, y = x / 10, millis = x, shift = x and 2 == 0, finger = finger)
                when (what) {
                    0, 1 -> if (down.add(finger)) gestures.press(at)
                    2 -> gestures.move(at)
                    3 -> if (down.remove(finger)) gestures.release(at)
                    4 -> gestures.giveUp()
                    else -> if (down.remove(finger)) gestures.cancel(at)
                }
                if (down.isEmpty()) plot.drag.shouldBeNull()
                if (down.isEmpty()) gestures.isActive shouldBe false
                (plot.visible.from >= 0.0 && plot.visible.to <= 100.0 && plot.visible.width > 0) shouldBe true
            }
        }
    }
})
