package badlog.viewer.state

import badlog.core.analysis.EnabledSpan
import badlog.core.analysis.Span
import badlog.core.recording.Severity
import badlog.rules.Finding
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardHistory
import badlog.viewer.choices.range.Viewport
import badlog.viewer.draw.mark.FindingPlace
import badlog.viewer.input.KeyAction
import badlog.viewer.shown.cursor.CursorSteps
import badlog.viewer.shown.cursor.Cursors
import badlog.viewer.shown.finding.RuleResults
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.bind
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll

class ReducePlaceSpec : FunSpec({
    class Log(override val newest: Double? = null) : Shown {
        override val samples = CursorSteps(emptyList())
        override val enabled = emptyList<EnabledSpan>()
        override val found: RuleResults? = null
        override val graphs = Board()
    }

    val beginning = ViewerState(Place(Viewport(Span(0.0, 100.0))), BoardHistory())
    fun ViewerState.after(vararg actions: Action, log: Log = Log()) = actions.fold(this) { state, action -> reduce(state, log, action).state }
    val previous = Action.Press(KeyAction.PREVIOUS_VIEW)

    val finding = Finding("Rule", Severity.ERROR, null, "Rule", 3.0, listOf(Span(3.0, 4.0)), 1, "s", false, emptyList(), "")
    val visited = FindingPlace(finding, Severity.ERROR, Span(3.0, 4.0))

    test("another log begins without cursors, selection, finding and earlier ranges, and without staying at the end") {
        val left = beginning.after(
            PlaceAction.Show(10.0, 20.0),
            PlaceAction.GoTo(12.0),
            PlaceAction.Select(Span(1.0, 2.0)),
            PlaceAction.Visit(visited),
            PlaceAction.GoToEnd,
            log = Log(newest = 100.0),
        )
        left.after(PlaceAction.Open(Span(0.0, 5.0))) shouldBe ViewerState(Place(Viewport(Span(0.0, 5.0))), left.board)
    }

    test("the end of a growing log is followed, and the end of any other is shown once") {
        val there = beginning.after(PlaceAction.Show(90.0, 100.0), PlaceAction.GoToEnd, log = Log(newest = 100.0))
        there.after(PlaceAction.Grow(Span(0.0, 110.0))).place.run {
            range.visible shouldBe Span(100.0, 110.0)
            cursors.pinned shouldBe 110.0
        }
        beginning.after(PlaceAction.GoToEnd).after(PlaceAction.Grow(Span(0.0, 110.0))).place.cursors.pinned shouldBe 100.0
        val paused = there.after(PlaceAction.Pause)
        paused.after(PlaceAction.Grow(Span(0.0, 110.0))).place.range.visible shouldBe Span(90.0, 100.0)
        beginning.after(PlaceAction.Grow(Span(0.0, 110.0)), PlaceAction.FollowEnd).place.cursors.pinned shouldBe 110.0
    }

    test("another x axis is shown completely, without pins or selections of the previous one") {
        val there = beginning.after(PlaceAction.Show(90.0, 95.0), PlaceAction.GoTo(91.0))
        there.after(PlaceAction.Grow(Span(0.0, 5.0), isOtherAxis = true)).place shouldBe Place(Viewport(Span(0.0, 5.0)))
    }

    test("a shown range can be left with back, the steps of a gesture are one, and a gesture can be undone") {
        val shown = beginning.after(PlaceAction.Show(20.0, 40.0))
        shown.after(previous).place.range.visible shouldBe Span(0.0, 100.0)
        val panned = shown.after(PlaceAction.Remember, PlaceAction.Shift(5.0), PlaceAction.Shift(5.0), PlaceAction.Scale(0.5, 40.0), PlaceAction.Move(50.0, 60.0))
        panned.place.range.visible shouldBe Span(50.0, 60.0)
        panned.after(previous).place.range.visible shouldBe Span(20.0, 40.0)
        panned.after(PlaceAction.Range(shown.place.range)) shouldBe shown
    }

    test("the selected range is shown, if there is one") {
        beginning.after(PlaceAction.ShowSelection) shouldBe beginning
        val selected = beginning.after(PlaceAction.Select(Span(30.0, 40.0)), PlaceAction.ShowSelection)
        selected.place.range.visible shouldBe Span(30.0, 40.0)
        selected.after(PlaceAction.Cancel).place.selection shouldBe null
    }

    test("pointers stay within the log, a click pins the cursor, and a click with Shift places the second one") {
        beginning.after(PlaceAction.Hover(120.0)).place.cursors shouldBe Cursors(hover = 100.0)
        val clicked = beginning.after(PlaceAction.Hover(5.0), PlaceAction.Click(-3.0, 1.0, isShifted = false))
        clicked.place.cursors shouldBe Cursors(pinned = 0.0, hover = 5.0)
        clicked.after(PlaceAction.Click(7.0, 1.0, isShifted = true), PlaceAction.Leave).place.cursors shouldBe Cursors(0.0, 7.0)
        clicked.after(PlaceAction.Click(0.5, 1.0, isShifted = false)).place.cursors.isPinned shouldBe false
        clicked.after(PlaceAction.Point(Cursors(hover = 5.0))).place.cursors shouldBe Cursors(hover = 5.0)
    }

    test("a cursor that something else moves stays pinned if it was, and going to a place pins it") {
        beginning.after(PlaceAction.MoveCursor(3.0)).place.cursors shouldBe Cursors(hover = 3.0)
        val pinned = beginning.after(PlaceAction.Show(20.0, 40.0), PlaceAction.GoTo(80.0))
        pinned.place.cursors shouldBe Cursors(pinned = 80.0)
        (80.0 in pinned.place.range.visible) shouldBe true
        pinned.after(PlaceAction.MoveCursor(3.0)).place.cursors shouldBe Cursors(pinned = 3.0)
        beginning.after(PlaceAction.GoTo(50.0, isWithSurroundings = true)).place.range.isZoomed shouldBe true
    }

    test("a click on the overview shows its place with the same width, unless it is visible") {
        val there = beginning.after(PlaceAction.Show(20.0, 40.0))
        there.after(PlaceAction.Pick(30.0)).place shouldBe there.place.copy(cursors = Cursors(pinned = 30.0))
        there.after(PlaceAction.Pick(80.0)).place.range.visible shouldBe Span(70.0, 90.0)
        there.after(PlaceAction.Pick(80.0), previous).place.range.visible shouldBe Span(20.0, 40.0)
    }

    test("a finding is selected at the person's place, and deselected") {
        val there = beginning.after(PlaceAction.GoTo(50.0), PlaceAction.Visit(visited))
        there.place.cursors.pinned shouldBe 50.0
        there.place.visited shouldBe visited
        there.after(PlaceAction.Visit(null)).place.visited shouldBe null
    }

    test("after any actions, the visible range is within the log, and the board stays") {
        val numbers = Arb.double(-50.0, 150.0, false)
        val actions = Arb.bind(Arb.element((0..9).toList()), numbers, numbers) { kind, x, y ->
            when (kind) {
                0 -> PlaceAction.Show(x, y)
                1 -> PlaceAction.Move(x, y)
                2 -> PlaceAction.Shift(x)
                3 -> PlaceAction.Scale(y / 50, x)
                4 -> PlaceAction.GoTo(x)
                5 -> PlaceAction.Click(x, 1.0, y > 0)
                6 -> PlaceAction.Remember
                7 -> PlaceAction.Cancel
                8 -> previous
                else -> PlaceAction.Pick(x)
            }
        }
        checkAll(Arb.list(actions, 0..40)) { all ->
            val end = beginning.after(*all.toTypedArray())
            end.place.range.visible.run { from >= 0.0 && to <= 100.0 && from < to } shouldBe true
            end.board shouldBe beginning.board
        }
    }
})
