package badlog.window.graph

import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardGraph
import badlog.window.bagOf
import badlog.window.compare.DrawnRecording
import badlog.window.graph.plot.drawnLines
import badlog.window.graph.plot.laneName
import badlog.window.recordingOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.shouldBe

class LegendSpec : FunSpec({
    val names = List(8) { "Drivetrain/Module $it/Azimuth encoder position of the absolute sensor" }
    val long = recordingOf(bagOf(listOf("Time|xaxis") + names, listOf(0, 1).map { row -> (listOf(row) + names.indices).joinToString(",") }))

    test("the menu of a graph offers every other graph to add it to") {
        val viewer = viewerOf(long).apply { board.replace(Board(List(30) { BoardGraph(it + 1, "Graph $it", listOf(names[it % 8])) })) }
        graphActions(viewer.graphs, viewer.board.state.graphs.first()).last() shouldHaveSize 29
    }

    test("each lane of compared recordings has its recording's name") {
        val states = recordingOf(bagOf(listOf("Time|xaxis", "On", "Mode"), listOf("0,true,false", "1,false,true")))
        val two = listOf(DrawnRecording(states, name = "Qualification 42"), DrawnRecording(states, 1.0, "Qualification 57"))
        val alone = drawnLines(BoardGraph(1, "On", listOf("On")), two)
        alone.map { laneName(it, alone) } shouldContainExactly listOf("Qualification 42", "Qualification 57")
        val both = drawnLines(BoardGraph(1, "Both", listOf("On", "Mode")), two)
        both.map { laneName(it, both) }.take(2) shouldContainExactly listOf("On · Qualification 42", "On · Qualification 57")
        val single = drawnLines(BoardGraph(1, "On", listOf("On")), two.take(1))
        laneName(single[0], single) shouldBe "On"
    }
})
