package badlog.viewer.session

import badlog.core.analysis.EnabledSpan
import badlog.core.analysis.Span
import badlog.core.recording.Severity
import badlog.rules.Finding
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardHistory
import badlog.viewer.choices.range.Viewport
import badlog.viewer.draw.mark.FindingPlace
import badlog.viewer.draw.mark.FindingTimeline
import badlog.viewer.input.Action
import badlog.viewer.shown.cursor.CursorSteps
import badlog.viewer.shown.cursor.Cursors
import badlog.viewer.shown.finding.FindingOrder
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.types.shouldBeInstanceOf
import io.kotest.property.Arb
import io.kotest.property.arbitrary.enum
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll

class AfterSpec : FunSpec({
    fun found(rule: String, severity: Severity, vararg spans: Span): Finding {
        val time = spans.firstOrNull()?.from ?: Double.NaN
        return Finding(rule, severity, null, rule, time, spans.toList(), spans.size, "s", false, emptyList(), "")
    }

    val early = found("Early", Severity.ERROR, Span(21.0, 30.0))
    val late = found("Late", Severity.WARNING, Span(81.0, 81.0))

    class Log(
        override val samples: CursorSteps = CursorSteps(listOf(DoubleArray(101) { it.toDouble() })),
        override val enabled: List<EnabledSpan> = emptyList(),
        override val findings: FindingOrder? = FindingOrder(FindingTimeline(listOf(early, late), { it.severity }, { it.places }), emptyList()),
        override val newest: Double? = null,
    ) : Shown

    val board = Board().withGraph(listOf("A")).withGraph(listOf("B")).withGraph(listOf("C"))
    val beginning = Session(Place(Viewport(Span(0.0, 100.0))), BoardHistory(board), graph = board.graphs[1].id)
    val log = Log()

    fun Session.then(vararg actions: Action) = actions.fold(this) { session, action -> after(session, log, action).session }
    fun Session.names() = this.board.now.graphs.map { it.lines.single() }

    test("the cursor of keys begins at the sample in the middle, goes on by samples, and is shown when it leaves what is visible") {
        beginning.then(Action.NEXT_SAMPLE).place.cursors.pinned shouldBe 50.0
        beginning.then(Action.NEXT_SAMPLE, Action.NEXT_SAMPLE, Action.TEN_SAMPLES_BACK).place.cursors.pinned shouldBe 41.0
        val far = beginning.then(Action.NEXT_SAMPLE, Action.ZOOM_IN, Action.ZOOM_IN, Action.ZOOM_IN, Action.ZOOM_IN, Action.TEN_SAMPLES_ON)
            .then(Action.TEN_SAMPLES_ON)
        (70.0 in far.place.range.visible) shouldBe true
        after(beginning, log, Action.NEXT_SAMPLE).request shouldBe Request.Cursor
    }

    test("a mark goes to the cursor, or else to the middle of what is visible; in a log that grows, to the newest moment") {
        after(beginning, log, Action.MARK).request shouldBe Request.Mark(50.0)
        after(beginning.then(Action.NEXT_SAMPLE, Action.NEXT_SAMPLE), log, Action.MARK).request shouldBe Request.Mark(51.0)
        after(beginning.then(Action.NEXT_SAMPLE), Log(newest = 100.0), Action.MARK).request shouldBe Request.Mark(100.0)
    }

    test("a log without samples has nothing to step to") {
        val outcome = after(beginning, Log(samples = CursorSteps(emptyList())), Action.NEXT_SAMPLE)
        outcome.session shouldBe beginning
        outcome.request shouldBe null
    }

    test("keys move the second cursor while there is one") {
        beginning.then(Action.NEXT_SAMPLE, Action.SECOND_CURSOR, Action.NEXT_SAMPLE).place.cursors shouldBe Cursors(50.0, 51.0)
        beginning.then(Action.NEXT_SAMPLE, Action.SECOND_CURSOR, Action.SECOND_CURSOR).place.cursors.second shouldBe null
    }

    test("the next finding takes range and cursor with it, asks for its evidence, and a key brings the range back") {
        val outcome = after(beginning, log, Action.NEXT_FINDING)
        val place = outcome.session.place
        place.visited?.finding shouldBe early
        place.cursors.pinned shouldBe 21.0
        (place.range.visible.width < 20) shouldBe true
        outcome.request.shouldBeInstanceOf<Request.Finding>().step.place.finding shouldBe early
        outcome.session.then(Action.NEXT_FINDING).place.visited?.finding shouldBe late
        outcome.session.then(Action.PREVIOUS_VIEW).place.range.visible shouldBe Span(0.0, 100.0)
    }

    test("before the rules have run, the key for the next finding goes nowhere, and says so") {
        val outcome = after(beginning, Log(findings = null), Action.NEXT_FINDING)
        outcome.session shouldBe beginning
        outcome.request shouldBe Request.NoFinding
    }

    test("a finding about the whole log is selected where the person is") {
        val whole = found("Whole", Severity.ERROR)
        val timeline = FindingTimeline(listOf(whole), { it.severity }, { it.places })
        timeline.places shouldBe emptyList()
        val place = beginning.then(Action.ZOOM_IN).place
        val after = place.visiting(FindingPlace(whole, whole.severity, Span(Double.NaN, Double.NaN)))
        after.range.visible shouldBe place.range.visible
        after.cursors shouldBe place.cursors
        after.visited?.finding shouldBe whole
    }

    test("graphs are moved and resized, each of which can be undone and done again") {
        beginning.then(Action.MOVE_UP).names() shouldBe listOf("B", "A", "C")
        beginning.then(Action.MOVE_DOWN).names() shouldBe listOf("A", "C", "B")
        beginning.then(Action.MOVE_DOWN, Action.MOVE_TO_TOP).names() shouldBe listOf("B", "A", "C")
        after(beginning, log, Action.MOVE_UP).request shouldBe Request.Graph(board.graphs[1].id)
        beginning.then(Action.MOVE_UP, Action.UNDO).names() shouldBe listOf("A", "B", "C")
        beginning.then(Action.MOVE_UP, Action.UNDO, Action.REDO).names() shouldBe listOf("B", "A", "C")
        beginning.then(Action.NEXT_HEIGHT).board.now.graphs[1].height shouldBe 380
    }

    test("without a graph that keys apply to, the board stays") {
        val session = Session(beginning.place, beginning.board)
        for (action in listOf(Action.MOVE_UP, Action.MOVE_DOWN, Action.MOVE_TO_TOP, Action.NEXT_HEIGHT)) {
            after(session, log, action).session shouldBe session
            after(session, log, action).request shouldBe null
        }
    }

    test("a note is asked for at the cursor, or else in the middle of what is visible") {
        after(beginning, log, Action.NEW_NOTE).request shouldBe Request.Note(50.0)
        after(beginning.then(Action.NEXT_SAMPLE, Action.NEXT_SAMPLE), log, Action.NEW_NOTE).request shouldBe Request.Note(51.0)
    }

    test("whatever keys are pressed, what is visible stays within the log, and place and board are changed by no request alone") {
        checkAll(Arb.list(Arb.enum<Action>(), 0..60)) { actions ->
            var session = beginning
            for (action in actions) {
                val outcome = after(session, log, action)
                val visible = outcome.session.place.range.visible
                (visible.from >= 0.0 && visible.to <= 100.0 && visible.from < visible.to) shouldBe true
                outcome.session.board.now.graphs.size shouldBe 3
                if (outcome.request is Request.Note || outcome.request is Request.Frames || outcome.request == Request.Values) {
                    outcome.session shouldBe session
                }
                session = outcome.session
            }
        }
    }

    test("what is cancelled goes one at a time: selection, second cursor, first cursor, pointer") {
        var place = Place(Viewport(Span(0.0, 100.0)), Cursors(1.0, 2.0, 3.0), Span(4.0, 5.0))
        place = place.cancelled()
        place shouldBe Place(Viewport(Span(0.0, 100.0)), Cursors(1.0, 2.0, 3.0))
        place = place.cancelled()
        place.cursors shouldBe Cursors(1.0, null, 3.0)
        place.cancelled().cancelled().cursors shouldBe Cursors()
    }
})
