package badlog.window.graph

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.test.DesktopComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.onAllNodesWithContentDescription
import androidx.compose.ui.test.onAllNodesWithText
import androidx.compose.ui.test.onLast
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.onRoot
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performMouseInput
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.defaultBoard
import badlog.viewer.state.PlaceAction
import badlog.window.app.Viewer
import badlog.window.app.actionCommands
import badlog.window.graph.plot.drawnLines
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import badlog.window.bagOf as bagOfTopics

@OptIn(ExperimentalTestApi::class)
class GraphPaneSpec : FunSpec({
    test("without a recording, the pane says how to open one") {
        runDesktopComposeUiTest(900, 600) {
            setContent { TestGraphs(viewerOf(null)) }
            onNodeWithText("Select a log at the left, or drop a file here.").assertExists()
        }
    }

    test("a graph out of sight is scrolled to when it is requested") {
        val viewer = viewerOf(recordingOf(bagOf(100) { 0.0 }))
        viewer.settings.change { copy(fitsGraphs = false) }
        viewer.board.replace(Board(List(12) { BoardGraph(it + 1, "Graph $it", listOf("A/Voltage")) }))
        runDesktopComposeUiTest(900, 600) {
            setContent { TestGraphs(viewer) }
            waitForIdle()
            (12 in viewer.board.inSight.orEmpty()) shouldBe false
            runOnIdle { viewer.board.goTo(12) }
            waitForIdle()
            (12 in viewer.board.inSight.orEmpty()) shouldBe true
            viewer.board.wanted shouldBe null
        }
    }

    test("when all graphs were removed, a button restores the standard ones") {
        val viewer = viewerOf(recordingOf(bagOf(100) { 0.0 }))
        runDesktopComposeUiTest(900, 600) {
            setContent { TestGraphs(viewer) }
            val graph = onNodeWithContentDescription("Graph A/Voltage")
            graph.performMouseInput { moveTo(center) }
            waitForIdle()
            // A person reads the legend over the plot: only the menu is there, beside it.
            onNodeWithContentDescription("More for this graph").assertExists()
            onNodeWithContentDescription("Remove this graph").assertDoesNotExist()
            graph.performMouseInput { moveTo(Offset(300f, 8f)) }
            waitForIdle()
            onNodeWithContentDescription("Remove this graph").performClick()
            viewer.board.state.graphs.size shouldBe 0
            onNodeWithContentDescription("Show the default graphs").performClick()
            viewer.board.state.graphs.size shouldBe 1
        }
    }

    test("a thousand topics of states are drawn as graphs of some lanes each") {
        val names = (0 until 1000).joinToString(",") { """{"name":"S$it","unit":"ul","attrs":[]}""" }
        val row = (0 until 1000).joinToString(",") { "A" }
        val viewer = viewerOf(recordingOf("""{"topics":[$names],"values":[]}""" + "\n" + (0 until 1000).joinToString(",") { "S$it" } + "\n$row\n$row\n"))
        viewer.board.replace(defaultBoard(checkNotNull(viewer.current.recording).view))
        viewer.board.state.graphs.all { it.lines.size <= 16 } shouldBe true
        runDesktopComposeUiTest(900, 600) {
            setContent { TestGraphs(viewer) }
            waitForPictures(viewer)
        }
    }

    test("graphs share the height if they fit, and otherwise have the set height") {
        fun heights(lanes: List<Int>, room: Int, own: Int? = null) = graphHeights(lanes.map { BoardGraph(0, "", emptyList(), height = own) }, lanes, room, usual = 150, fit = true)
        heights(listOf(0, 0, 0), room = 300) shouldBe listOf(100, 100, 100)
        heights(listOf(0, 0, 0), room = 170) shouldBe listOf(150, 150, 150)
        heights(listOf(0, 2, 0), room = 300).let {
            it[1] shouldBe 64
            it[0] shouldBe 118
        }
        heights(listOf(0, 2), room = 300, own = 200) shouldBe listOf(200, 64)
        heights(emptyList(), room = 300) shouldBe emptyList()
    }

    test("each key has its own meaning") {
        val viewer = viewerOf(recordingOf(bagOf(101) { 0.0 }))
        val commands =
            actionCommands(viewer.view::press)
        commands.map { it.meaning }.distinct().size shouldBe commands.size
        val right = commands.first { it.meaning == "Cursor to the next sample" }
        viewer.view.send(PlaceAction.MoveCursor(5.0))
        right.action()
        viewer.view.cursor shouldBe 5.1
        viewer.view.send(PlaceAction.MoveCursor(5.17))
        right.action()
        viewer.view.cursor shouldBe 5.2
        commands.first { it.meaning == "Cursor ten samples back" }.action()
        viewer.view.cursor shouldBe 4.2
        commands.map { it.group } shouldContain "Graphs"
    }

    test("of eight lines with long names, those without room are counted, and listed with their values") {
        val names = List(8) { "Drivetrain/Module $it/Azimuth encoder position of the absolute sensor" }
        val viewer = viewerOf(recordingOf(bagOfTopics(listOf("Time|xaxis") + names, List(2) { row -> (listOf(row) + names.indices).joinToString(",") }))).apply {
            board.replace(Board(listOf(BoardGraph(1, "Azimuths", names))))
            view.send(PlaceAction.MoveCursor(1.0))
        }
        runDesktopComposeUiTest(700, 600) {
            setContent { TestGraphs(viewer) }
            waitForPictures(viewer)
            val titles = drawnLines(viewer.board.state.graphs.single(), viewer.compared.drawn).map { it.title }
            onNodeWithContentDescription(" more lines of Azimuths", substring = true).performClick()
            for (title in titles) {
                val places = onAllNodesWithText(title, useUnmergedTree = true).fetchSemanticsNodes().filter { it.layoutInfo.isPlaced }
                places.size shouldBeGreaterThan 0
            }
            savePicture("legend-more")
            onAllNodesWithContentDescription("Hide ${titles.last()}").onLast().performClick()
            viewer.board.state.graphs.single().hidden shouldBe setOf(names.last())
        }
    }

    /** Drags graph [dragged] by its title to the [share] of the height of graph [onto]. */
    fun DesktopComposeUiTest.take(dragged: String, onto: String, share: Float) {
        val from = onNodeWithContentDescription("Graph $dragged").fetchSemanticsNode().boundsInRoot
        val to = onNodeWithContentDescription("Graph $onto").fetchSemanticsNode().boundsInRoot
        onRoot().performMouseInput {
            moveTo(from.topLeft + Offset(14f, 10f))
            press()
            moveTo(from.topLeft + Offset(30f, 14f))
            moveTo(Offset(60f, to.top + to.height * share))
        }
    }

    fun DesktopComposeUiTest.letGo() {
        onRoot().performMouseInput { release() }
        waitForIdle()
    }

    fun lines(viewer: Viewer) = viewer.board.state.graphs.map { it.lines.joinToString("+") }

    test("a graph dragged by its title is moved above, below or into another one, and undo moves it back") {
        val viewer = viewerOf(recordingOf(bagOfTopics(listOf("Time|xaxis", "A", "B", "C"), List(20) { "$it,$it,${it * 2},${it * 3}" })))
        viewer.board.replace(Board().withGraph(listOf("A")).withGraph(listOf("B")).withGraph(listOf("C")))
        runDesktopComposeUiTest(900, 600) {
            setContent { TestGraphs(viewer) }
            waitForPictures(viewer)
            take("C", "A", 0.1f)
            savePicture("graph-dragged-above")
            letGo()
            lines(viewer) shouldContainExactly listOf("C", "A", "B")
            take("C", "B", 0.9f)
            letGo()
            lines(viewer) shouldContainExactly listOf("A", "B", "C")
            take("B", "A", 0.5f)
            savePicture("graph-dragged-into")
            letGo()
            lines(viewer) shouldContainExactly listOf("A+B", "C")
            viewer.board.undo()
            lines(viewer) shouldContainExactly listOf("A", "B", "C")
        }
    }
})
