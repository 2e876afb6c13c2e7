package badlog.viewer.state

import badlog.core.analysis.EnabledSpan
import badlog.core.analysis.Span
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardHistory
import badlog.viewer.choices.range.Viewport
import badlog.viewer.shown.cursor.CursorSteps
import badlog.viewer.shown.finding.RuleResults
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class StoreSpec : FunSpec({
    test("an action that is sent while the shell returns its graphs is not lost") {
        val cell = object : StateCell {
            override var state = ViewerState(Place(Viewport(Span(0.0, 10.0))), BoardHistory(Board()))
        }
        lateinit var store: Store
        var isFirst = true
        val shown = object : Shown {
            override val samples = CursorSteps(emptyList())
            override val enabled = emptyList<EnabledSpan>()
            override val found: RuleResults? = null
            override val graphs: Board
                get() {
                    if (isFirst) {
                        isFirst = false
                        store.send(PlaceAction.Hover(4.0))
                    }
                    return cell.state.board.now
                }
        }
        store = Store(cell, shown) {}
        store.send(GraphChange.Add(listOf("A")))
        store.state.place.cursors.x shouldBe 4.0
        store.state.board.now.graphs.single().lines shouldBe listOf("A")
    }
})
