package badlog.window.layout

import badlog.viewer.choices.board.Board
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class MergedLayoutSpec : FunSpec({
    test("of a formula that both have changed, the later change counts") {
        val start = Layout(Layout.VERSION, formulas = listOf("X = 1", "Y = 1"))
        val both = merged(start.copy(formulas = listOf("X = 2", "Y = 2")), start, start.copy(formulas = listOf("X = 1", "Y = 3", "Z = 1")))
        both.formulas.toSet() shouldBe setOf("X = 2", "Y = 2", "Z = 1")
    }

    fun board(line: String) = Board().withGraph(listOf(line))

    val before = Layout(Layout.VERSION, board("A"), "a.bag", LayoutSpan(0.0, 1.0), formulas = listOf("X = 1", "Y = 1"))

    test("what one window changed is kept, whichever of the two writes last") {
        val graphs = before.copy(graphs = board("B"))
        val panels = before.copy(panels = LayoutPanels(topics = false), formulas = listOf("X = 1", "Z = 1"))
        val both = before.copy(graphs = board("B"), panels = LayoutPanels(topics = false), formulas = listOf("X = 1", "Z = 1"))
        merged(graphs, before, panels) shouldBe both
        merged(panels, before, graphs) shouldBe both
    }

    test("of what both changed, the one that writes last wins, and the log goes with what is seen of it") {
        val theirs = before.copy(graphs = board("B"), recording = "b.bag", visible = LayoutSpan(5.0, 6.0))
        val mine = before.copy(graphs = board("C"), visible = LayoutSpan(0.2, 0.3))
        merged(mine, before, theirs) shouldBe mine
        merged(before.copy(graphs = board("C")), before, theirs) shouldBe theirs.copy(graphs = board("C"))
    }
})
