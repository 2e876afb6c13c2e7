package badlog.window.graph

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.graphics.toPixelMap
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.captureToImage
import androidx.compose.ui.test.hasContentDescription
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performMouseInput
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import badlog.core.analysis.Span
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.choices.board.defaultBoard
import badlog.viewer.state.PlaceAction
import badlog.window.app.actionCommands
import badlog.window.theme.Palette
import badlog.window.theme.Theme
import badlog.window.theme.ViewerTheme
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe
import kotlin.math.abs

@OptIn(ExperimentalTestApi::class)
class GraphPaneSpec : FunSpec({
    test("a single sample among a hundred thousand is visible") {
        val viewer = viewerOf(recordingOf(bagOf(100_000) { if (it == 50_000) 100.0 else 1.0 }))
        runDesktopComposeUiTest(900, 600) {
            setContent { TestGraphs(viewer) }
            waitForPictures(viewer)
            val plot = onNodeWithContentDescription("Plot A/Voltage").captureToImage().toPixelMap()
            val line = Palette.LIGHT.line(0)
            val middle = plot.height / 2
            val seen = (0 until plot.width).filter { x ->
                val color = plot[x, middle]
                abs(color.red - line.red) + abs(color.green - line.green) + abs(color.blue - line.blue) < 0.9f
            }
            seen.isNotEmpty() shouldBe true
            seen.all { abs(it - plot.width / 2) <= 2 } shouldBe true
        }
    }

    test("without a recording, the pane says how to open one") {
        runDesktopComposeUiTest(900, 600) {
            setContent { TestGraphs(viewerOf(null)) }
            onNodeWithText("Select a log at the left, or drop a file here.").assertExists()
        }
    }

    test("while a log is being read, the pane shows that, not that no log is open") {
        runDesktopComposeUiTest(900, 600) {
            setContent { ViewerTheme(Theme.LIGHT) { GraphPane(viewerOf(null).graphs, isOpening = true) } }
            onNodeWithText("Opening the log…").assertExists()
            onNodeWithText("No log is open").assertDoesNotExist()
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

    test("a recording without samples has a sentence about that") {
        val viewer = viewerOf(recordingOf(bagOf(0) { 0.0 }))
        runDesktopComposeUiTest(900, 600) {
            setContent { TestGraphs(viewer) }
            onNodeWithText("There is nothing to draw in this log").assertExists()
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

    test("a name of 500 letters, a single row, and a graph of a formula not calculated yet do not fail") {
        val name = "Folder ".repeat(40) + "/" + "n".repeat(300)
        val text = """{"topics":[{"name":"$name","unit":"${"u".repeat(300)}","attrs":[]}],"values":[]}""" + "\n$name\n1\n"
        val viewer = viewerOf(recordingOf(text))
        viewer.formulas.add("Not there = 1", "Not there")
        viewer.view.send(PlaceAction.MoveCursor(0.0))
        viewer.view.send(PlaceAction.Select(Span(-0.2, 0.2)))
        runDesktopComposeUiTest(360, 500) {
            setContent { TestGraphs(viewer) }
            waitForPictures(viewer)
            onNodeWithText("not in this log").assertExists()
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

    test("zooming to the enabled time is offered if a topic shows it") {
        val viewer = viewerOf(sample("qualification-42.bag"))
        runDesktopComposeUiTest(900, 600) {
            setContent { TestGraphs(viewer) }
            onNode(hasContentDescription("Zoom to the time the robot was enabled (E)")).performClick()
            viewer.view.viewport.visible.from shouldBe (2.018268 plusOrMinus 1e-9)
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
})
