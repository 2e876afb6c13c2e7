package badlog.window.layout

import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.identifiedByLines
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class MergedLayoutSpec : FunSpec({
    test("if both windows have changed a formula, the later change counts") {
        val start = Layout(Layout.VERSION, formulas = listOf("X = 1", "Y = 1"))
        val both = merged(start.copy(formulas = listOf("X = 2", "Y = 2")), start, start.copy(formulas = listOf("X = 1", "Y = 3", "Z = 1")))
        both.formulas.toSet() shouldBe setOf("X = 2", "Y = 2", "Z = 1")
    }

    fun board(line: String) = Board().withGraph(listOf(line)).identifiedByLines()

    val before = Layout(Layout.VERSION, board("A"), "a.bag", LayoutSpan(0.0, 1.0), formulas = listOf("X = 1", "Y = 1"))

    test("a change of one window is kept, whichever of the two writes last") {
        val graphs = before.copy(graphs = board("B"))
        val panels = before.copy(panels = LayoutPanels(topics = false), formulas = listOf("X = 1", "Z = 1"))
        val both = before.copy(graphs = board("B"), panels = LayoutPanels(topics = false), formulas = listOf("X = 1", "Z = 1"))
        merged(graphs, before, panels) shouldBe both
        merged(panels, before, graphs) shouldBe both
    }

    test("if both windows have changed a part, the last one to write wins, and the log keeps its visible range") {
        val theirs = before.copy(graphs = board("B"), recording = "b.bag", visible = LayoutSpan(5.0, 6.0))
        val mine = before.copy(graphs = board("C"), visible = LayoutSpan(0.2, 0.3))
        merged(mine, before, theirs).run { Triple(recording, visible, graphs?.graphs?.map { it.title }) } shouldBe
            Triple("a.bag", LayoutSpan(0.2, 0.3), listOf("C", "B"))
        merged(before.copy(panels = LayoutPanels(topics = false)), before, theirs) shouldBe theirs.copy(panels = LayoutPanels(topics = false))
    }

    test("graphs are merged one by one, and do not draw formulas that one of the two has removed") {
        val graphs = Board().withGraph(listOf("A")).withGraph(listOf("X", "B")).withGraph(listOf("Y"))
        val start = before.copy(graphs = graphs)
        val mine = start.copy(graphs = graphs.resized(1, 100).without(3), formulas = listOf("X = 1"))
        val theirs = start.copy(graphs = graphs.resized(1, 200).resized(2, 200).withGraph(listOf("Y")), formulas = listOf("Y = 1"))
        val both = merged(mine, start, theirs)
        both.formulas shouldBe emptyList()
        both.graphs?.graphs?.map { it.lines to it.height } shouldBe listOf(listOf("A") to 100, listOf("B") to 200)
        merged(start.copy(graphs = null), start, theirs).graphs shouldBe null
    }
})
