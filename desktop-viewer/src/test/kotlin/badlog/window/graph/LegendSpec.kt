package badlog.window.graph

import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.onAllNodesWithContentDescription
import androidx.compose.ui.test.onAllNodesWithText
import androidx.compose.ui.test.onLast
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performMouseInput
import androidx.compose.ui.test.performTextInput
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.state.PlaceAction
import badlog.window.bagOf
import badlog.window.compare.DrawnRecording
import badlog.window.graph.plot.drawnLines
import badlog.window.graph.plot.laneName
import badlog.window.recordingOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe

@OptIn(ExperimentalTestApi::class)
class LegendSpec : FunSpec({
    val names = List(8) { "Drivetrain/Module $it/Azimuth encoder position of the absolute sensor" }
    val long = recordingOf(bagOf(listOf("Time|xaxis") + names, listOf(0, 1).map { row -> (listOf(row) + names.indices).joinToString(",") }))

    test("of eight lines with long names, those without room are counted, and listed with their values") {
        val viewer = viewerOf(long).apply {
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

    test("the menu of a graph offers every other graph to add it to") {
        val viewer = viewerOf(long).apply { board.replace(Board(List(30) { BoardGraph(it + 1, "Graph $it", listOf(names[it % 8])) })) }
        graphActions(viewer.graphs, viewer.board.state.graphs.first()).last() shouldHaveSize 29
    }

    test("the menu of a graph among many has a search for the graph to add it to") {
        val viewer = viewerOf(long).apply { board.replace(Board(List(30) { BoardGraph(it + 1, "Graph $it", listOf(names[it % 8])) })) }
        runDesktopComposeUiTest(900, 900) {
            setContent { TestGraphs(viewer) }
            waitForPictures(viewer)
            onNodeWithContentDescription("Graph Graph 0").performMouseInput { moveTo(center) }
            waitForIdle()
            onNodeWithContentDescription("More for this graph").performClick()
            onNodeWithContentDescription("Search graphs to add it to").performTextInput("17")
            onNodeWithText("Add to “Graph 16”").assertDoesNotExist()
            onNodeWithText("Add to “Graph 17”").performClick()
            viewer.board.state.graphs.single { it.title == "Graph 17" }.lines shouldBe listOf(names[1], names[0])
        }
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
