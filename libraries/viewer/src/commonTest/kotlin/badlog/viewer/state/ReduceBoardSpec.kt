package badlog.viewer.state

import badlog.core.analysis.EnabledSpan
import badlog.core.analysis.Span
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.BoardHistory
import badlog.viewer.choices.board.fittedTo
import badlog.viewer.choices.range.Viewport
import badlog.viewer.input.KeyAction
import badlog.viewer.shown.cursor.CursorSteps
import badlog.viewer.shown.finding.RuleResults
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll

class ReduceBoardSpec : FunSpec({
    class Log(override val graphs: Board) : Shown {
        override val samples = CursorSteps(emptyList())
        override val enabled = emptyList<EnabledSpan>()
        override val found: RuleResults? = null
    }

    val abc = Board().withGraph(listOf("A")).withGraph(listOf("B")).withGraph(listOf("C"))
    val beginning = ViewerState(Place(Viewport(Span(0.0, 100.0))), BoardHistory(abc))

    /** The graphs that a log without the line "?" can draw. */
    fun ViewerState.drawn() = board.now.fittedTo { it != "?" }.board
    fun ViewerState.outcome(action: Action) = reduce(this, Log(drawn()), action)
    fun ViewerState.after(vararg actions: Action) = actions.fold(this) { state, action -> state.outcome(action).state }
    fun ViewerState.lines() = board.now.graphs.map { it.lines.joinToString("+") }
    val undo = Action.Press(KeyAction.UNDO)
    val redo = Action.Press(KeyAction.REDO)

    test("each change of graphs has its effect, and can be undone") {
        val changes = mapOf(
            GraphChange.Add(listOf("D", "E"), before = 2) to listOf("A", "D+E", "B", "C"),
            GraphChange.AddEach(listOf("D", "E")) to listOf("A", "B", "C", "D", "E"),
            GraphChange.AddAll(listOf(BoardGraph(0, "D", listOf("D")))) to listOf("A", "B", "C", "D"),
            GraphChange.AddLines(1, listOf("A", "D")) to listOf("A+D", "B", "C"),
            GraphChange.AddToLast(listOf("D")) to listOf("A", "B", "C+D"),
            GraphChange.ToggleLine(1, "D") to listOf("A+D", "B", "C"),
            GraphChange.ToggleLine(1, "A") to listOf("B", "C"),
            GraphChange.RemoveLine(2, "B") to listOf("A", "C"),
            GraphChange.Toggle(abc.graphs[0]) to listOf("B", "C"),
            GraphChange.ToggleOwn("C") to listOf("A", "B"),
            GraphChange.ToggleOwn("D", listOf("D", "E")) to listOf("A", "B", "C", "D+E"),
            GraphChange.ShowOnly(abc.graphs.take(1)) to listOf("A"),
            GraphChange.ShowOnlyLines(listOf("D", "E")) to listOf("D+E"),
            GraphChange.ShowOnlyLines(emptyList()) to listOf("A", "B", "C"),
            GraphChange.Replace(abc.graphs[0].copy(lines = listOf("D"))) to listOf("D", "B", "C"),
            GraphChange.Remove(2) to listOf("A", "C"),
            GraphChange.Move(1, 2) to listOf("B", "C", "A"),
            GraphChange.MoveBefore(3, 1) to listOf("C", "A", "B"),
            GraphChange.Drop(1, 2, 0.5) to listOf("B+A", "C"),
            GraphChange.Join(1, 3) to listOf("A+C", "B"),
            BoardAction.Show(abc.without(1)) to listOf("B", "C"),
            BoardAction.ShowAll(Board().withGraph(listOf("D"))) to listOf("D"),
        )
        for ((change, lines) in changes) {
            val changed = beginning.after(change)
            changed.lines() shouldBe lines
            changed.after(undo).lines() shouldBe listOf("A", "B", "C")
            if (changed.board.canUndo) beginning.outcome(change).request shouldBe Request.Graphs(abc)
        }
        beginning.after(GraphChange.Join(1, 3), GraphChange.Separate(1)).lines() shouldBe listOf("A", "C", "B")
    }

    test("the look of a graph is changed for it alone") {
        val y = Span(1.0, 2.0)
        val looks = listOf(
            GraphChange.Resize(1, 380) to abc.graphs[0].copy(height = 380),
            GraphChange.ShowY(1, y, null) to abc.graphs[0].copy(yRange = y),
            GraphChange.ShareY(1, true) to abc.graphs[0].copy(sharesY = true),
            GraphChange.DrawXy(1, true) to abc.graphs[0].copy(isXy = true),
            GraphChange.ShowPlane(1, y, y) to abc.graphs[0].copy(xRange = y, yRange = y),
            GraphChange.HideLines(1, setOf("A", "D"), true) to abc.graphs[0].copy(hidden = setOf("A")),
        )
        for ((change, graph) in looks) beginning.after(change).board.now.graphs shouldBe listOf(graph) + abc.graphs.drop(1)
    }

    test("graphs that the log cannot draw stay in place when others are changed") {
        val all = beginning.after(BoardAction.Begin(abc.withGraph(listOf("?"), before = 1)))
        all.after(GraphChange.Remove(1)).lines() shouldBe listOf("?", "B", "C")
        all.after(GraphChange.ShowOnly(emptyList())).lines() shouldBe listOf("?")
    }

    test("another log begins with its graphs and without a history, and a received board is undone to them") {
        val begun = beginning.after(GraphChange.Remove(1), BoardAction.Begin(abc))
        begun.board.canUndo shouldBe false
        val sent = begun.after(BoardAction.Begin(abc, visited = Board().withGraph(listOf("D"))))
        sent.lines() shouldBe listOf("D")
        sent.after(undo).lines() shouldBe listOf("A", "B", "C")
        val visited = begun.outcome(BoardAction.Visit(Board().withGraph(listOf("D"))))
        visited.state.lines() shouldBe listOf("D")
        visited.request shouldBe null
    }

    test("renaming or removing a formula also changes undone boards") {
        val changed = beginning.after(GraphChange.Remove(1), BoardAction.Rename("A", "D"))
        changed.after(undo).lines() shouldBe listOf("D", "B", "C")
        val gone = beginning.after(GraphChange.Remove(2), BoardAction.Forget(setOf("A")))
        gone.lines() shouldBe listOf("C")
        gone.after(undo).lines() shouldBe listOf("B", "C")
        beginning.outcome(BoardAction.Forget(setOf("A"))).request shouldBe Request.Graphs(abc)
        // Removing a formula that is on no graph does not change the board, which is then not remembered.
        beginning.outcome(BoardAction.Forget(setOf("D"))).request shouldBe null
    }

    test("taking back a board keeps later changes") {
        val start = beginning.after(BoardAction.ShowAll(Board().withGraph(listOf("D"))))
        val more = start.after(GraphChange.Add(listOf("E")))
        more.after(BoardAction.Revert(abc, start.board.now)).lines().toSet() shouldBe setOf("A", "B", "C", "E")
    }

    test("the graphs of a finding are first, replace the previous finding's, and undoing restores these") {
        fun show(line: String) = BoardAction.ShowEvidence(Board().withGraph(listOf(line)))
        val first = beginning.after(show("X"))
        val second = first.after(show("Y"))
        second.lines() shouldBe listOf("Y", "A", "B", "C")
        second.evidenceIn(second.drawn()).graphs.map { it.title } shouldBe listOf("Y")
        second.arranged shouldBe abc
        second.after(undo).run { evidenceIn(drawn()).graphs.map { it.title } } shouldBe listOf("X")
        second.after(show("Y")).board shouldBe second.board
        val kept = second.after(BoardAction.Keep())
        kept.after(show("Z")).lines() shouldBe listOf("Z", "Y", "A", "B", "C")
        val changed = second.after(GraphChange.AddLines(second.board.now.graphs[0].id, listOf("A")))
        changed.evidenceIn(changed.drawn()) shouldBe Board()
    }

    test("other initial graphs stay below a finding's, and the first finding adds its own unless a person was quicker") {
        val shown = beginning.after(BoardAction.ShowEvidence(Board().withGraph(listOf("X"))))
        val below = shown.after(BoardAction.BeginBelowEvidence(Board().withGraph(listOf("D"))))
        below.lines() shouldBe listOf("X", "D")
        below.evidenceIn(below.drawn()).graphs.map { it.title } shouldBe listOf("X")
        val found = BoardAction.BeginWithEvidence(abc.withGraph(listOf("X"), before = 1))
        val begun = beginning.after(found)
        begun.lines() shouldBe listOf("X", "A", "B", "C")
        begun.arranged shouldBe abc
        val quick = beginning.after(GraphChange.Remove(1))
        quick.after(found) shouldBe quick
    }

    test("any changes of graphs can be undone step by step to the first board, and redone") {
        val deeds = Arb.element(
            GraphChange.Remove(1),
            GraphChange.Add(listOf("D")),
            GraphChange.Move(2, -1),
            GraphChange.ToggleOwn("B"),
            GraphChange.Join(2, 3),
            GraphChange.Resize(3, 200),
            GraphChange.ShowOnly(emptyList()),
        )
        checkAll(Arb.list(deeds, 0..30)) { all ->
            val end = beginning.after(*all.toTypedArray())
            var state = end
            while (state.board.canUndo) state = state.after(undo)
            state.board.now shouldBe abc
            while (state.board.canRedo) state = state.after(redo)
            state.board.now shouldBe end.board.now
        }
    }
})
