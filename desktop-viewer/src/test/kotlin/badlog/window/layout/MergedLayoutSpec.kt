package badlog.window.layout

import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardGraph
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class MergedLayoutSpec : FunSpec({
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
        val mine = before.copy(visible = LayoutSpan(0.2, 0.3))
        merged(mine, before, theirs) shouldBe mine.copy(graphs = board("B"))
        merged(before.copy(compared = LayoutComparison(listOf("c.bag"))), before, theirs).recording shouldBe "b.bag"
    }

    test("graphs and formulas are merged one by one: each is as the window has it that changed it, the later one if both did") {
        val graphs = board("A").withGraph(listOf("B"))
        val start = before.copy(graphs = graphs)
        val mine = start.copy(graphs = graphs.resized(1, 100).withGraph(listOf("C")), formulas = listOf("X = 2", "Y = 2"))
        val theirs = start.copy(graphs = graphs.without(2).resized(1, 200).withLine(1, "D"), formulas = listOf("X = 1", "Y = 3", "Z = 1"))
        val both = merged(mine, start, theirs)
        both.graphs?.graphs?.map { it.lines to it.height } shouldBe listOf(listOf("A", "D") to 100, listOf("C") to null)
        both.formulas.toSet() shouldBe setOf("X = 2", "Y = 2", "Z = 1")
    }

    test("graphs that another window has added to those that a log begins with stay there when this one adds its own") {
        val start = board("A")
        val none = before.copy(graphs = null)
        val mine = none.copy(graphs = Board(start.graphs + BoardGraph(50, "Mine", listOf("Mine"))))
        val theirs = none.copy(graphs = Board(start.graphs + BoardGraph(60, "Theirs", listOf("Theirs"))))
        merged(mine, none, theirs, start).graphs?.graphs?.map { it.title } shouldBe listOf("A", "Mine", "Theirs")
    }
})
