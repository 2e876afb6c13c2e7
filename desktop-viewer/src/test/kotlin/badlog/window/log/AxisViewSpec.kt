package badlog.window.log

import badlog.core.analysis.EnabledSpan
import badlog.core.analysis.Span
import badlog.viewer.choices.board.Board
import badlog.viewer.input.DragKind
import badlog.viewer.session.gesture.PlotDrag
import badlog.viewer.shown.cursor.CursorSteps
import badlog.viewer.shown.finding.RuleResults
import badlog.viewer.state.BoardAction
import badlog.viewer.state.PlaceAction
import badlog.viewer.state.Shown
import badlog.viewer.state.Store
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.shouldNotBe

class AxisViewSpec : FunSpec({
    val nothing = object : Shown {
        override val samples = CursorSteps(emptyList())
        override val enabled = emptyList<EnabledSpan>()
        override val found: RuleResults? = null
        override val graphs = Board()
    }

    test("a drag ends without effect when another log or another x axis comes, but not when the log grows") {
        val view = AxisView(Store(StateVariable(), nothing) {})
        fun drag() = PlotGesture(null, PlotDrag(DragKind.PAN, 1.0, 0.0, view.viewport))
        for (another in listOf(PlaceAction.Open(Span(0.0, 5.0)), PlaceAction.Grow(Span(0.0, 6.0), isOtherAxis = true))) {
            view.gesture = drag()
            view.send(another)
            view.gesture shouldBe null
        }
        view.gesture = drag()
        view.send(PlaceAction.Grow(Span(0.0, 7.0)))
        view.gesture shouldNotBe null
    }

    test("graphs are not fitted to the log again while the cursor moves") {
        var asked = 0
        val store = Store(StateVariable(), nothing) {}
        val board = GraphBoard(store) { ++asked > 0 }
        store.send(BoardAction.Begin(Board().withGraph(listOf("A", "B"))))
        board.state.graphs.size shouldBe 1
        board.evidence.graphs.size shouldBe 0
        val first = asked
        store.send(PlaceAction.Open(Span(0.0, 100.0)))
        repeat(20) {
            store.send(PlaceAction.Hover(it.toDouble()))
            board.state.graphs.size shouldBe 1
            board.arranged.graphs.size shouldBe 1
            board.evidence.graphs.size shouldBe 0
        }
        asked shouldBe first
    }
})
