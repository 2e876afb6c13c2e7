package badlog.viewer.session.link

import badlog.core.analysis.EnabledSpan
import badlog.core.analysis.Span
import badlog.core.recording.Severity
import badlog.rules.Finding
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardHistory
import badlog.viewer.choices.range.Viewport
import badlog.viewer.draw.mark.FindingPlace
import badlog.viewer.shown.cursor.CursorSteps
import badlog.viewer.shown.cursor.Cursors
import badlog.viewer.shown.finding.RuleResults
import badlog.viewer.state.FindingAction
import badlog.viewer.state.Place
import badlog.viewer.state.PlaceAction
import badlog.viewer.state.Shown
import badlog.viewer.state.ViewerState
import badlog.viewer.state.reduce
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

internal class KeptPlaceSpec : FunSpec({
    val span = Span(20.0, 30.0)
    val late = Finding("Loop stood still", Severity.ERROR, "Loop time", "Late.", 20.0, listOf(span), 1, "s", false, emptyList(), "")
    val other = Finding("Brownout", Severity.ERROR, null, "Low.", 20.0, listOf(span), 1, "s", false, emptyList(), "")

    fun logWith(results: RuleResults?) = object : Shown {
        override val samples = CursorSteps(emptyList())
        override val enabled = emptyList<EnabledSpan>()
        override val found = results
        override val graphs = Board()
    }

    val known = logWith(RuleResults(listOf(other, late)))
    val beginning = ViewerState(Place(Viewport(Span(0.0, 100.0))), BoardHistory(Board()))
    val left = beginning.copy(place = beginning.place.copy(cursors = Cursors(25.0, 28.5), visited = FindingPlace(late, late.severity, span)))

    fun ViewerState.back(text: String, log: Shown) = actionsOfKept(text).fold(this) { state, action -> reduce(state, log, action).state }

    test("cursors and the selected finding come back, and the visible range stays") {
        left.place.keptText shouldBe "#t=25&b=28.5 #t=20&finding=Loop+stood+still;Loop+time"
        val back = beginning.back(left.place.keptText, known).place
        back.cursors shouldBe Cursors(25.0, 28.5)
        back.visited?.finding shouldBe late
        back.range shouldBe beginning.place.range
    }

    test("the finding waits for the rules, and is still kept meanwhile") {
        val waiting = beginning.back(left.place.keptText, logWith(null))
        waiting.place.visited shouldBe null
        waiting.place.keptText shouldBe left.place.keptText
        reduce(waiting, known, FindingAction.Know).state.place.visited?.finding shouldBe late
        reduce(waiting, known, PlaceAction.Open(Span(0.0, 1.0))).state.place.keptText shouldBe ""
    }

    test("a finding that no longer exists is not replaced by another one at the same time") {
        beginning.back(left.place.keptText, logWith(RuleResults(listOf(other)))).place.visited shouldBe null
    }

    test("a log without a pinned cursor and a selected finding stores no place") {
        beginning.place.keptText shouldBe ""
        actionsOfKept("") shouldBe emptyList()
    }
})
