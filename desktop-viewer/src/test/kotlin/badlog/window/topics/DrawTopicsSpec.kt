package badlog.window.topics

import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardGraph
import badlog.window.bagOf
import badlog.window.graph.recordingOf
import badlog.window.graph.viewerOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class DrawTopicsSpec : FunSpec({
    test("a click on a drawn topic scrolls to its graph if that is out of sight, and otherwise removes it") {
        val viewer = viewerOf(recordingOf(bagOf(listOf("Time|xaxis", "A/Voltage", "B"), listOf("0,1,2", "1,2,3"))))
        val signal = checkNotNull(viewer.current.recording?.signal("A/Voltage"))
        val board = Board(listOf(BoardGraph(1, "B", listOf("B")), BoardGraph(2, "A/Voltage", listOf("A/Voltage"))))
        viewer.board.replace(board)
        fun click() = toggleDrawn(viewer.current, viewer.board, viewer.events, viewer.panels, signal)
        viewer.board.inSight = setOf(1)
        click()
        viewer.board.state shouldBe board
        viewer.board.wanted shouldBe 2
        viewer.board.inSight = setOf(1, 2)
        click()
        viewer.board.state.graphs.map { it.id } shouldBe listOf(1)
    }

    test("clicks add topics to the graph in the line above or remove them, until that ends") {
        val viewer = viewerOf(recordingOf(bagOf(listOf("Time|xaxis", "A/Voltage", "B"), listOf("0,1,2", "1,2,3"))))
        val signal = checkNotNull(viewer.current.recording?.signal("A/Voltage"))
        viewer.board.replace(Board(listOf(BoardGraph(7, "B", listOf("B")))))
        fun click() = toggleIn(viewer.current, viewer.board, viewer.events, viewer.topics, viewer.panels, signal)
        viewer.graphs.addTopics(7)
        viewer.topics.state.isSearchAsked shouldBe true
        click()
        viewer.board.state.graphs.map { it.lines } shouldBe listOf(listOf("B", "A/Voltage"))
        click()
        viewer.board.state.graphs.map { it.lines } shouldBe listOf(listOf("B"))
        viewer.topics.change { adding(null) }
        click()
        viewer.board.state.graphs.map { it.lines } shouldBe listOf(listOf("B"), listOf("A/Voltage"))
    }
})
