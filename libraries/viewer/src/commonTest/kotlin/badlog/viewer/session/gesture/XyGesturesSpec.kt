package badlog.viewer.session.gesture

import badlog.core.analysis.Span
import badlog.viewer.choices.board.BoardLines
import badlog.viewer.choices.board.FieldOrigin
import badlog.viewer.choices.board.Plane
import badlog.viewer.choices.range.Viewport
import badlog.viewer.draw.path.Field
import badlog.viewer.draw.path.LogPaths
import badlog.viewer.draw.path.XyLog
import badlog.viewer.draw.path.XyPicture
import badlog.viewer.input.PointerButton
import badlog.viewer.shown.cursor.Cursors
import badlog.viewer.state.Action
import badlog.viewer.state.Place
import badlog.viewer.timedTopic
import badlog.viewer.timedView
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe

class XyGesturesSpec : FunSpec({
    /** A path along y = 5 from x = 0 to 10, a unit each second. Its plane is 10 by 10. The log is drawn [offset] later. */
    class TestPath(offset: Double = 0.0) : XyTarget {
        private val view = timedView(
            timedTopic("A", *Array(11) { it * 1.0 to it * 1.0 }),
            timedTopic("B", *Array(11) { it * 1.0 to 5.0 }),
        )
        private val paths = LogPaths(view, Field.PLAIN, BoardLines(view)::get)
        override val picture = XyPicture(listOf("A", "B"), FieldOrigin.BLUE, listOf(XyLog(paths, offset = offset)))
        override var place = Place(Viewport(Span(0.0, 20.0)))
        override var plane: Plane? = null
        override var drag: XyDrag? = null
        val all = Plane(Span(0.0, 10.0), Span(0.0, 10.0))

        override fun seen(width: Double, height: Double): Plane = plane ?: all

        override fun send(action: Action) {
            place = place.after(action)
        }
    }

    test("a pointer near the path moves the cursor to the time of that place, a click pins it, and elsewhere nothing happens") {
        val path = TestPath()
        val gestures = XyGestures(path)
        gestures.move(pointer(400, y = 50))
        path.place.cursors.hover.shouldNotBeNull() shouldBe (4.0 plusOrMinus 0.5)
        gestures.stroke(pointer(700, y = 45))
        path.place.cursors.pinned.shouldNotBeNull() shouldBe (7.0 plusOrMinus 0.5)
        val before = path.place
        gestures.stroke(pointer(700, y = -40, millis = 1000))
        path.place shouldBe before
    }

    test("on a log that is drawn later, the cursor moves to the later x") {
        val path = TestPath(offset = 3.0)
        XyGestures(path).move(pointer(400, y = 50))
        path.place.cursors.hover.shouldNotBeNull() shouldBe (7.0 plusOrMinus 0.5)
    }

    test("a drag zooms to its frame, in any direction, and a double click shows everything") {
        val path = TestPath()
        path.place = path.place.copy(cursors = Cursors(pinned = 1.0))
        val gestures = XyGestures(path)
        gestures.press(pointer(600, y = 80))
        gestures.move(pointer(200, y = 40))
        path.drag?.at?.x shouldBe 200.0
        path.plane.shouldBeNull()
        gestures.release(pointer(200, y = 40))
        path.plane shouldBe Plane(Span(2.0, 6.0), Span(2.0, 6.0))
        path.drag.shouldBeNull()
        gestures.stroke(pointer(500, y = 25))
        gestures.stroke(pointer(500, y = 25, millis = 100))
        path.plane.shouldBeNull()
        path.place.cursors.pinned shouldBe 1.0
    }

    test("Shift, the middle button and a finger move the plane, and the touched place stays below the pointer") {
        for (start in listOf(pointer(500, shift = true), pointer(500, button = PointerButton.MIDDLE), pointer(500, finger = 1))) {
            val path = TestPath()
            XyGestures(path).stroke(start, pointer(600, y = 70, finger = start.finger))
            path.plane.shouldNotBeNull().x.from shouldBe (-1.0 plusOrMinus 1e-9)
            path.plane.shouldNotBeNull().y.from shouldBe (2.0 plusOrMinus 1e-9)
        }
    }

    test("Escape restores the plane, also if all of it was visible") {
        for (kept in listOf(null, Plane(Span(1.0, 5.0), Span(1.0, 5.0)))) {
            for (shift in listOf(true, false)) {
                val path = TestPath()
                path.plane = kept
                val gestures = XyGestures(path)
                gestures.press(pointer(200, shift = shift))
                gestures.move(pointer(400, y = 80))
                (path.plane == kept) shouldBe !shift
                gestures.giveUp()
                gestures.release(pointer(400, y = 80))
                path.plane shouldBe kept
                path.drag.shouldBeNull()
            }
        }
    }

    test("two fingers that part zoom in between them, the wheel with Ctrl zooms, and alone it scrolls") {
        val path = TestPath()
        val gestures = XyGestures(path)
        gestures.press(pointer(400, finger = 1))
        gestures.press(pointer(600, finger = 2))
        gestures.move(pointer(300, finger = 1))
        gestures.move(pointer(700, finger = 2))
        path.plane.shouldNotBeNull().x.from shouldBe (2.5 plusOrMinus 1e-9)
        path.plane.shouldNotBeNull().x.to shouldBe (7.5 plusOrMinus 1e-9)
        path.plane = null
        gestures.wheel(pointer(500), 0.0, -40.0) shouldBe false
        gestures.wheel(pointer(500, ctrl = true), 0.0, -40.0) shouldBe true
        val zoomed = path.plane.shouldNotBeNull()
        zoomed.x.from + zoomed.x.to shouldBe (10.0 plusOrMinus 1e-9)
        (zoomed.x.width < 8) shouldBe true
    }
})
