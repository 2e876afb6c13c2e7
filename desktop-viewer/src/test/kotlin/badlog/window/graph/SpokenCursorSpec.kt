package badlog.window.graph

import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.SemanticsMatcher
import androidx.compose.ui.test.assertTextEquals
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.performMouseInput
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.BoardGraph
import badlog.viewer.input.KeyAction
import badlog.viewer.state.PlaceAction
import badlog.window.app.ViewerScreen
import badlog.window.bagOf
import badlog.window.change
import badlog.window.recordingOf
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe

@OptIn(ExperimentalTestApi::class)
class SpokenCursorSpec : FunSpec({
    val rows = List(11) { "$it,${12 - it},${it * 2}" }
    val log = recordingOf(bagOf(listOf("Time|xaxis", "Voltage", "Current"), rows))
    val region = SemanticsMatcher.expectValue(SemanticsProperties.LiveRegion, LiveRegionMode.Polite)

    fun viewer() = viewerOf(log).apply { board.replace(Board(listOf(BoardGraph(1, "Battery", listOf("Voltage", "Current"))))) }

    test("a live region has the cursor's place and values after a key, not after a move of the pointer") {
        val viewer = viewer()
        runDesktopComposeUiTest(1200, 800) {
            setContent { ViewerScreen(viewer) }
            onNode(region).assertTextEquals("")
            onNodeWithContentDescription("Plot Battery").performMouseInput { moveTo(center) }
            waitForIdle()
            viewer.view.cursor.shouldNotBeNull()
            onNode(region).assertTextEquals("")

            runOnIdle {
                viewer.view.send(PlaceAction.MoveCursor(4.0))
                viewer.view.press(KeyAction.NEXT_SAMPLE)
            }
            onNode(region).assertTextEquals("5.000 V, Voltage 7 V, Current 10 V")
            // A screen reader ignores elements without a size.
            onNode(region).fetchSemanticsNode().size.width shouldBeGreaterThan 0

            onNodeWithContentDescription("Plot Battery").performMouseInput { moveTo(centerLeft) }
            waitForIdle()
            onNode(region).assertTextEquals("5.000 V, Voltage 7 V, Current 10 V")
        }
    }

    test("the text for screen readers is about the cursor that keys move, without the values of hidden lines") {
        val viewer = viewer()
        viewer.board.change { withLineHidden(1, "Voltage", true) }
        viewer.view.send(PlaceAction.MoveCursor(4.0))
        viewer.view.press(KeyAction.SECOND_CURSOR)
        viewer.view.press(KeyAction.NEXT_SAMPLE)
        viewer.spoken.state shouldBe "5.000 V, Current 10 V"
    }

    test("the text for screen readers has a finding with its place") {
        val viewer = viewer()
        viewer.view.send(PlaceAction.GoTo(3.0))
        viewer.spoken.sayFinding("Browned out")
        viewer.spoken.state shouldBe "3.000 V: Browned out"
    }
})
