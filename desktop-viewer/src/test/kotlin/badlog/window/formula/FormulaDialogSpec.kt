package badlog.window.formula

import androidx.compose.runtime.LaunchedEffect
import androidx.compose.ui.input.key.Key
import androidx.compose.ui.test.DesktopComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.onAllNodesWithContentDescription
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performKeyInput
import androidx.compose.ui.test.performTextInput
import androidx.compose.ui.test.performTextReplacement
import androidx.compose.ui.test.pressKey
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import badlog.window.app.Viewer
import badlog.window.app.ViewerScreen
import badlog.window.bagOf
import badlog.window.compare.Comparison
import badlog.window.graph.savePicture
import badlog.window.graph.viewerOf
import badlog.window.graph.waitForPictures
import badlog.window.recordingOf
import badlog.window.waiting.waitFor
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe

@OptIn(ExperimentalTestApi::class)
@Tags("InCheck")
class FormulaDialogSpec : FunSpec({
    val topics = listOf("Time|xaxis", "System/Battery Voltage", "PDP/Total Current")
    fun bag(volts: Int) = recordingOf(bagOf(topics, List(50) { "$it,$volts,${it % 7}" }), "volts-$volts.bag")

    fun over(viewer: Viewer, width: Int = 1200, test: DesktopComposeUiTest.() -> Unit) = runDesktopComposeUiTest(width, 700) {
        setContent {
            ViewerScreen(viewer)
            LaunchedEffect(Unit) { viewer.shown.run() }
        }
        waitForPictures(viewer)
        test()
    }

    val field = "Definition of the formula"

    test("Enter saves a formula even right after the key that completed it") {
        val viewer = viewerOf(bag(12))
        over(viewer) {
            onNodeWithContentDescription("New formula… (F)").performClick()
            onNodeWithContentDescription(field).performTextInput("Power [W] = volt")
            onNodeWithContentDescription("Insert System/Battery Voltage").assertExists()
            mainClock.autoAdvance = false
            onNodeWithContentDescription(field).performKeyInput {
                pressKey(Key.Tab, 1)
                pressKey(Key.Enter, 1)
            }
            mainClock.autoAdvance = true
            waitFor { viewer.current.recording?.signal("Power") != null && viewer.formulas.sheet == null }
        }
    }

    test("a formula is written with suggested names, drawn, calculated in compared logs, changed, and removed") {
        val viewer = viewerOf(bag(12))
        val other = bag(6)
        viewer.compared.change { Comparison(checked = listOf(other.file), loaded = mapOf(other.file to other)) }
        over(viewer) {
            onNodeWithContentDescription("New formula… (F)").performClick()
            onNodeWithContentDescription(field).performTextInput("Power [W] = volt")
            onNodeWithContentDescription("Insert System/Battery Voltage").assertExists()
            onNodeWithContentDescription(field).performKeyInput { pressKey(Key.Tab) }
            onNodeWithText("Power [W] = System/Battery Voltage").assertExists()
            onNodeWithContentDescription(field).performTextInput(" * cur")
            onNodeWithText("“cur” is not a topic", substring = true).assertExists()
            savePicture("formula-error")
            onNodeWithContentDescription(field).performKeyInput { pressKey(Key.DirectionDown) }
            onNodeWithContentDescription(field).performKeyInput { pressKey(Key.Enter) }
            onNodeWithText("Makes the topic “Power”.").assertExists()
            onNodeWithContentDescription(field).performKeyInput { pressKey(Key.Enter) }
            waitFor { viewer.current.recording?.signal("Power") != null }
            waitFor { viewer.compared.state.loaded.values.single().signal("Power") != null }
            viewer.formulas.sheet shouldBe null
            viewer.board.state.graphs.last().lines.single() shouldBe "Power"
            viewer.compared.state.loaded.values.single().signal("Power").shouldNotBeNull().series.y[1] shouldBe 6.0
            waitFor { onAllNodesWithContentDescription("Topic Power").fetchSemanticsNodes().isNotEmpty() }
            waitForPictures(viewer)
            savePicture("formula-drawn")

            viewer.formulas.edit(viewer.formulas.definitions.single())
            waitForIdle()
            onNodeWithContentDescription(field).performTextReplacement("Half = System/Battery Voltage / 2")
            onNodeWithContentDescription("Save the formula (Enter)").performClick()
            waitFor { viewer.current.recording?.signal("Half") != null }
            viewer.current.recording?.signal("Power") shouldBe null
            viewer.board.state.graphs.last().title shouldBe "Half"

            val graphs = viewer.board.state.graphs.size
            viewer.formulas.edit(viewer.formulas.definitions.single())
            waitForIdle()
            onNodeWithContentDescription("Remove this formula").performClick()
            waitFor { viewer.current.recording?.signal("Half") == null }
            viewer.formulas.definitions shouldBe emptyList()
            viewer.board.state.graphs.size shouldBe graphs - 1
        }
    }
})
