package badlog.viewer.choices.board

import badlog.viewer.bagView
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe

class FittedBoardSpec : FunSpec({
    val board = Board().withGraph(listOf("A", "B")).withLineHidden(1, "B", true).withGraph(listOf("C"))

    test("a board for a log that lacks topics names them") {
        val fitted = board.fittedTo { it == "A" }
        fitted.board.graphs.map { it.lines } shouldBe listOf(listOf("A"))
        fitted.board.graphs[0].hidden shouldBe emptySet()
        fitted.sentence shouldBe "1 graph hidden: topics not in this log (“B”, “C”)."
        board.fittedTo { it != "B" }.sentence shouldBe "Topics not in this log: “B”."
        board.fittedTo(excused = setOf("B", "C")) { it == "A" }.sentence shouldBe null
        board.fittedTo { true }.board.showsSame(board) shouldBe true
    }

    test("the lines of each graph of a log are found again, including derived ones") {
        val view = bagView(listOf("Time|xaxis", "A/Speed|delta", "A/Mode", "B|join:A/Speed"), listOf("0,1,auto,3", "1,2,teleop,4", "2,4,off,5"))
        val lines = BoardLines(view)
        val graphs = view.folders.flatMap { it.graphs }
        for (graph in graphs) {
            val spec = graph.asBoardGraph()
            spec.lines.map { lines[it].shouldNotBeNull().data.y.toList() } shouldBe graph.series.map { it.data.y.toList() }
        }
        lines["Nothing"] shouldBe null
        lines.names.containsAll(listOf("A/Speed", "A/Mode", "B")) shouldBe true
        defaultBoard(view).fittedTo { lines[it] != null }.sentence shouldBe null
    }
})
