package badlog.window.log

import badlog.viewer.choices.board.Board
import badlog.viewer.input.KeyAction
import badlog.window.app.Viewer
import badlog.window.bagOf
import badlog.window.change
import badlog.window.findings.findingsIn
import badlog.window.graph.sample
import badlog.window.graph.viewerOf
import badlog.window.kept
import badlog.window.recordingOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldNotContain
import io.kotest.matchers.shouldBe

class GraphBoardSpec : FunSpec({
    val names = "ABCDEFXY".map { "$it" }
    val log = recordingOf(bagOf(listOf("Time|xaxis") + names, List(2) { row -> (listOf("Time") + names).joinToString(",") { "$row" } }))

    fun abc() = viewerOf(log).board.apply { replace(Board().withGraph(listOf("A")).withGraph(listOf("B")).withGraph(listOf("C"))) }

    fun lines(board: GraphBoard) = board.state.graphs.map { it.lines }

    fun Viewer.perform(action: KeyAction) = commands.single { it.meaning == action.meaning }.action()

    test("a graph out of sight is scrolled to when it is added, or gets a line") {
        val board = abc()
        board.inSight = setOf(1, 2)
        board.change { withGraph(listOf("D")) }
        board.wanted shouldBe board.state.graphs.last().id
        board.goTo(null)
        board.change { withLinesInLast(listOf("E")) }
        board.wanted shouldBe board.state.graphs.last().id
        board.goTo(null)
        board.change { withLine(1, "F").without(3) }
        board.wanted shouldBe null
    }

    test("keys act on the graph that was pointed at last, or otherwise on the first in sight") {
        val board = abc()
        board.current?.id shouldBe 1
        board.inSight = setOf(2, 3)
        board.current?.id shouldBe 2
        board.pointed = 3
        board.current?.id shouldBe 3
        board.change { without(3) }
        board.current?.id shouldBe 2
    }

    test("a repeated key acts on the graph that it moved, until the pointer moves") {
        val viewer = viewerOf(sample("qualification-42.bag"))
        val before = viewer.board.state.graphs.map { it.id }
        viewer.board.pointed = before[2]
        viewer.perform(KeyAction.MOVE_UP)
        // The graph below the pointer now.
        viewer.board.pointed = before[1]
        viewer.perform(KeyAction.MOVE_UP)
        viewer.board.state.graphs.first().id shouldBe before[2]
        viewer.board.pointerMoved()
        viewer.perform(KeyAction.MOVE_TO_TOP)
        viewer.board.state.graphs.take(2).map { it.id } shouldBe listOf(before[1], before[2])
    }

    test("the default graphs come with a way back to a person's own graphs") {
        val viewer = viewerOf(sample("qualification-42.bag"))
        viewer.board.replace(Board().withGraph(listOf("System/Battery Voltage")))
        val own = viewer.board.state
        viewer.layouts.showStartBoard()
        (viewer.board.state == own) shouldBe false
        viewer.notices.all.single().action?.run?.invoke()
        viewer.board.state shouldBe own
    }

    test("a pinned graph of a finding stays when the next finding is shown") {
        val viewer = viewerOf(sample("qualification-42.bag"))
        viewer.findings.change { withList(findingsIn(checkNotNull(viewer.current.recording))) }
        viewer.findings.goTo(checkNotNull(viewer.findings.state.list).all.first { it.rule == "Browned out" })
        val graph = viewer.board.state.graphs.first()
        viewer.board.isEvidence(graph.id) shouldBe true
        viewer.board.kept.graphs shouldNotContain graph
        viewer.board.pointed = graph.id
        viewer.perform(KeyAction.PIN)
        viewer.board.kept.graphs shouldContain graph
        viewer.perform(KeyAction.PIN)
        viewer.board.state.graphs shouldNotContain graph
    }
})
