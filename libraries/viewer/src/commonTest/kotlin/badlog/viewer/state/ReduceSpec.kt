package badlog.viewer.state

import badlog.core.analysis.EnabledSpan
import badlog.core.analysis.Span
import badlog.core.recording.Severity
import badlog.rules.Finding
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardHistory
import badlog.viewer.choices.range.Viewport
import badlog.viewer.draw.mark.FindingPlace
import badlog.viewer.draw.mark.FindingTimeline
import badlog.viewer.input.KeyAction
import badlog.viewer.shown.cursor.CursorSteps
import badlog.viewer.shown.cursor.Cursors
import badlog.viewer.shown.finding.RuleResults
import badlog.viewer.shown.finding.firstPlace
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.types.shouldBeInstanceOf
import io.kotest.property.Arb
import io.kotest.property.arbitrary.enum
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll

class ReduceSpec : FunSpec({
    fun found(rule: String, severity: Severity, vararg spans: Span): Finding {
        val time = spans.firstOrNull()?.from ?: Double.NaN
        return Finding(rule, severity, null, rule, time, spans.toList(), spans.size, "s", false, emptyList(), "")
    }

    val early = found("Early", Severity.ERROR, Span(21.0, 30.0))
    val late = found("Late", Severity.WARNING, Span(81.0, 81.0))

    val board = Board().withGraph(listOf("A")).withGraph(listOf("B")).withGraph(listOf("C"))

    class Log(
        override val graphs: Board,
        override val graph: Int? = board.graphs[1].id,
        override val samples: CursorSteps = CursorSteps(listOf(DoubleArray(101) { it.toDouble() })),
        override val enabled: List<EnabledSpan> = emptyList(),
        override val found: RuleResults? = RuleResults(listOf(early, late)),
        override val newest: Double? = null,
    ) : Shown

    val beginning = ViewerState(Place(Viewport(Span(0.0, 100.0))), BoardHistory(board))
    val log = Log(board)

    fun after(state: ViewerState, shown: Shown, key: KeyAction) = reduce(state, shown, Action.Press(key))
    fun ViewerState.then(vararg keys: KeyAction) = keys.fold(this) { state, key -> after(state, Log(state.board.now), key).state }
    fun ViewerState.names() = this.board.now.graphs.map { it.lines.single() }

    test("a part of a panel stays as a person has last unfolded or folded it") {
        fun ViewerState.unfolding(fold: String, isOpen: Boolean) = reduce(this, log, Action.Unfold(fold, isOpen)).state
        beginning.unfolding("a", true).unfolding("b", true).unfolding("a", false).unfolded shouldBe mapOf("a" to false, "b" to true)
    }

    test("the cursor of keys begins at the middle sample, moves by samples, and is revealed when it leaves the visible range") {
        beginning.then(KeyAction.NEXT_SAMPLE).place.cursors.pinned shouldBe 50.0
        beginning.then(KeyAction.NEXT_SAMPLE, KeyAction.NEXT_SAMPLE, KeyAction.TEN_SAMPLES_BACK).place.cursors.pinned shouldBe 41.0
        val far = beginning.then(KeyAction.NEXT_SAMPLE, KeyAction.ZOOM_IN, KeyAction.ZOOM_IN, KeyAction.ZOOM_IN, KeyAction.ZOOM_IN, KeyAction.TEN_SAMPLES_ON)
            .then(KeyAction.TEN_SAMPLES_ON)
        (70.0 in far.place.range.visible) shouldBe true
        after(beginning, log, KeyAction.NEXT_SAMPLE).request shouldBe Request.Cursor
    }

    test("a mark is at the cursor, otherwise in the middle of the visible range, and in a growing log at the newest moment") {
        after(beginning, log, KeyAction.MARK).request shouldBe Request.Mark(50.0)
        after(beginning.then(KeyAction.NEXT_SAMPLE, KeyAction.NEXT_SAMPLE), log, KeyAction.MARK).request shouldBe Request.Mark(51.0)
        after(beginning.then(KeyAction.NEXT_SAMPLE), Log(board, newest = 100.0), KeyAction.MARK).request shouldBe Request.Mark(100.0)
    }

    test("a log without samples has no steps") {
        val outcome = after(beginning, Log(board, samples = CursorSteps(emptyList())), KeyAction.NEXT_SAMPLE)
        outcome.state shouldBe beginning
        outcome.request shouldBe null
    }

    test("keys move the second cursor while there is one") {
        beginning.then(KeyAction.NEXT_SAMPLE, KeyAction.SECOND_CURSOR, KeyAction.NEXT_SAMPLE).place.cursors shouldBe Cursors(50.0, 51.0)
        beginning.then(KeyAction.NEXT_SAMPLE, KeyAction.SECOND_CURSOR, KeyAction.SECOND_CURSOR).place.cursors.second shouldBe null
    }

    test("the next finding moves range and cursor, requests its evidence, and a key restores the range") {
        val outcome = after(beginning, log, KeyAction.NEXT_FINDING)
        val place = outcome.state.place
        place.visited?.finding shouldBe early
        place.cursors.pinned shouldBe 21.0
        (place.range.visible.width < 20) shouldBe true
        outcome.request.shouldBeInstanceOf<FindingRequest.Show>().place.finding shouldBe early
        outcome.state.then(KeyAction.NEXT_FINDING).place.visited?.finding shouldBe late
        outcome.state.then(KeyAction.PREVIOUS_VIEW).place.range.visible shouldBe Span(0.0, 100.0)
    }

    test("before the rules have run, the key for the next finding moves nothing, and a message gives the reason") {
        val outcome = after(beginning, Log(board, found = null), KeyAction.NEXT_FINDING)
        outcome.state shouldBe beginning
        outcome.request shouldBe FindingRequest.AnnounceNone
    }

    test("a finding about the whole log is selected at the person's place") {
        val whole = found("Whole", Severity.ERROR)
        val timeline = FindingTimeline(listOf(whole), { it.severity }, { it.places })
        timeline.places shouldBe emptyList()
        val place = beginning.then(KeyAction.ZOOM_IN).place
        val after = place.visiting(FindingPlace(whole, whole.severity, Span(Double.NaN, Double.NaN)))
        after.range.visible shouldBe place.range.visible
        after.cursors shouldBe place.cursors
        after.visited?.finding shouldBe whole
    }

    fun ViewerState.after(action: Action, found: RuleResults = RuleResults(listOf(early, late))) = reduce(this, Log(board, found = found), action)

    test("going to a finding requests its evidence, and more findings are listed on request") {
        val outcome = beginning.after(FindingAction.GoTo(late.firstPlace, null))
        outcome.state.place.visited?.finding shouldBe late
        outcome.request shouldBe FindingRequest.Show(outcome.state.place.visited!!, null, isWhole = false)
        outcome.state.findings shouldBe beginning.findings
        beginning.after(FindingAction.ListMore).state.findings.listed shouldBe 300
        beginning.after(FindingAction.ListMore).state.after(FindingAction.ListFew).state.findings.listed shouldBe null
    }

    test("steps within a finding stop at its last place, and do nothing without a visited finding") {
        val often = found("Often", Severity.ERROR, Span(10.0, 10.0), Span(30.0, 30.0))
        val log = RuleResults(listOf(often))
        val first = beginning.after(FindingAction.GoTo(often.firstPlace, null), log).state
        val second = first.after(FindingAction.StepWithin(1), log)
        second.state.place.cursors.pinned shouldBe 30.0
        (second.request as FindingRequest.Show).spoken shouldBe null
        second.state.after(FindingAction.StepWithin(1), log).state.place.cursors.pinned shouldBe 30.0
        beginning.after(FindingAction.StepWithin(1), log).state shouldBe beginning
    }

    test("a new search lists the first few again, a refusal is in the state, and both are forgotten with what is unfolded") {
        val searched = beginning.after(FindingAction.ListMore).state.after(FindingAction.Search("late")).state
        searched.findings shouldBe FindingsState(query = "late")
        beginning.after(FindingAction.Refuse("no")).state.findings.refusal shouldBe "no"
        searched.after(FindingAction.ListMore).state.copy(unfolded = mapOf("a" to true)).after(FindingAction.Forget).state shouldBe beginning
        beginning.after(Action.Ask(FindingRequest.RunRules)).request shouldBe FindingRequest.RunRules
    }

    test("without an open log, keys only open and close the panel of values") {
        val closed = object : Shown by log {
            override val isOpen = false
        }
        after(beginning, closed, KeyAction.ZOOM_IN).state shouldBe beginning
        after(beginning, closed, KeyAction.NEW_NOTE).request shouldBe null
        after(beginning, closed, KeyAction.CURSOR_VALUES).request shouldBe Request.Values
    }

    test("a store applies actions to the state, and forwards requests that only the shell can handle") {
        val cell = object : StateCell {
            override var state = beginning
        }
        val asked = ArrayList<Request>()
        val store = Store(cell, log, asked::add)
        store.send(Action.Press(KeyAction.NEXT_FINDING))
        store.state.place.visited?.finding shouldBe early
        asked.single().shouldBeInstanceOf<FindingRequest.Show>().spoken shouldBe "error: Early. Early"
    }

    test("graphs are moved and resized, and each change can be undone and redone") {
        beginning.then(KeyAction.MOVE_UP).names() shouldBe listOf("B", "A", "C")
        beginning.then(KeyAction.MOVE_DOWN).names() shouldBe listOf("A", "C", "B")
        beginning.then(KeyAction.MOVE_DOWN, KeyAction.MOVE_TO_TOP).names() shouldBe listOf("B", "A", "C")
        after(beginning, log, KeyAction.MOVE_UP).request shouldBe Request.Graphs(board, moved = board.graphs[1].id)
        after(beginning, log, KeyAction.NEXT_HEIGHT).request shouldBe Request.Graphs(board)
        after(beginning, log, KeyAction.UNDO).request shouldBe null
        beginning.then(KeyAction.MOVE_UP, KeyAction.UNDO).names() shouldBe listOf("A", "B", "C")
        beginning.then(KeyAction.MOVE_UP, KeyAction.UNDO, KeyAction.REDO).names() shouldBe listOf("B", "A", "C")
        beginning.then(KeyAction.NEXT_HEIGHT).board.now.graphs[1].height shouldBe 380
    }

    test("without a graph for keys, the board stays") {
        val nowhere = Log(board, graph = null)
        for (action in listOf(KeyAction.MOVE_UP, KeyAction.MOVE_DOWN, KeyAction.MOVE_TO_TOP, KeyAction.NEXT_HEIGHT)) {
            after(beginning, nowhere, action).state shouldBe beginning
            after(beginning, nowhere, action).request shouldBe null
        }
    }

    test("a note is requested at the cursor, otherwise in the middle of the visible range") {
        after(beginning, log, KeyAction.NEW_NOTE).request shouldBe Request.Note(50.0)
        after(beginning.then(KeyAction.NEXT_SAMPLE, KeyAction.NEXT_SAMPLE), log, KeyAction.NEW_NOTE).request shouldBe Request.Note(51.0)
    }

    test("a note is placed in the visible range, not at the pointer or at a cursor outside") {
        val hovering = reduce(beginning, log, PlaceAction.Hover(20.0)).state
        after(hovering, log, KeyAction.NEW_NOTE).request shouldBe Request.Note(50.0)
        val pinned = beginning.then(KeyAction.NEXT_SAMPLE)
        val away = reduce(pinned, log, PlaceAction.Show(80.0, 90.0)).state
        after(away, log, KeyAction.NEW_NOTE).request shouldBe Request.Note(85.0)
        after(away, log, KeyAction.MARK).request shouldBe Request.Mark(85.0)
    }

    test("after any keys, the visible range is within the log, and requests alone change neither place nor board") {
        checkAll(Arb.list(Arb.enum<KeyAction>(), 0..60)) { actions ->
            var state = beginning
            for (action in actions) {
                val outcome = after(state, Log(state.board.now), action)
                val visible = outcome.state.place.range.visible
                (visible.from >= 0.0 && visible.to <= 100.0 && visible.from < visible.to) shouldBe true
                outcome.state.board.now.graphs.size shouldBe 3
                if (outcome.request is Request.Note || outcome.request is Request.Frames || outcome.request == Request.Values) {
                    outcome.state shouldBe state
                }
                state = outcome.state
            }
        }
    }

    test("texts are copied and statistics across logs chosen without an open log, and another log keeps the choice") {
        val closed = object : Shown by log {
            override val isOpen = false
        }
        val copy = Request.Copy { "text" }
        reduce(beginning, closed, Action.Ask(copy)).request shouldBe copy
        reduce(beginning, closed, Action.Ask(Request.Formula)).request shouldBe null
        val chosen = reduce(beginning, closed, FolderAction.MeasureAcross(AcrossState(listOf("A"), search = "a"))).state
        reduce(chosen, log, PlaceAction.Open(Span(0.0, 1.0))).state.across shouldBe AcrossState(listOf("A"), search = "a")
    }

    test("Escape cancels one at a time: selection, second cursor, first cursor, pointer") {
        var place = Place(Viewport(Span(0.0, 100.0)), Cursors(1.0, 2.0, 3.0), Span(4.0, 5.0))
        place = place.cancelled()
        place shouldBe Place(Viewport(Span(0.0, 100.0)), Cursors(1.0, 2.0, 3.0))
        place = place.cancelled()
        place.cursors shouldBe Cursors(1.0, null, 3.0)
        place.cancelled().cancelled().cursors shouldBe Cursors()
    }
})
