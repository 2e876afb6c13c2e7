package badlog.window.app

import androidx.compose.ui.semantics.LiveRegionMode
import androidx.compose.ui.semantics.SemanticsProperties
import androidx.compose.ui.test.DesktopComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.SemanticsMatcher
import androidx.compose.ui.test.assertTextEquals
import androidx.compose.ui.test.getBoundsInRoot
import androidx.compose.ui.test.hasContentDescription
import androidx.compose.ui.test.hasText
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performMouseInput
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import androidx.compose.ui.unit.DpRect
import androidx.compose.ui.unit.dp
import androidx.compose.ui.unit.width
import badlog.catalog.folder.samples
import badlog.files.UserFolders
import badlog.viewer.input.KeyAction
import badlog.viewer.state.PlaceAction
import badlog.window.bagOf
import badlog.window.log.OpenRecording
import badlog.window.recordingOf
import badlog.window.sidebar.InspectorTab
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.comparables.shouldBeGreaterThan
import io.kotest.matchers.comparables.shouldBeLessThan
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import kotlinx.coroutines.MainScope

@OptIn(ExperimentalTestApi::class)
@Tags("InCheck")
class LabelsSpec : FunSpec({
    val match = OpenRecording.read(samples.resolve("qualification-42.bag").toAbsolutePath().normalize(), null)

    /** A log with a swerve drive, which has one more panel. */
    val swerve by lazy {
        val topics = List(3) { "Measured[$it]" }.flatMap { listOf("$it/speed", "$it/angle/value") }
        recordingOf(bagOf(listOf("Time|xaxis") + topics, listOf("0,1,0,1,0,1,0", "1,1,0,1,0,1,0")))
    }

    fun inWindow(width: Int, log: OpenRecording = match, steps: DesktopComposeUiTest.(Viewer) -> Unit) {
        val home = tempdir().toPath()
        val viewer = Viewer(MainScope(), UserFolders(home, home))
        viewer.show(log)
        runDesktopComposeUiTest(width, 1080) {
            setContent { ViewerScreen(viewer) }
            steps(viewer)
        }
    }

    /** The buttons of the bars at the top and above the graphs, by their words. Those that show more than words are left out. */
    val words = mapOf(
        "Logs: the list at the left" to "Logs",
        "Topics" to "Topics",
        "Statistics" to "Statistics",
        "Values" to "Values",
        "Video" to "Video",
        "Statistics across logs" to "Across logs",
        "Charts of the folder’s logs" to "Charts",
        "Theme: system" to "Theme",
        "Keys and gestures" to "Keys",
        "Previous view (Backspace)" to "Previous",
        "Zoom out (-)" to "Zoom out",
        "Zoom in (+)" to "Zoom in",
        "Play: moves the cursor (Space)" to "Play",
        "Loop the selection, or the visible range (L)" to "Loop",
        "Shorter graphs (Ctrl+Shift+wheel)" to "Shorter",
        "Taller graphs (Ctrl+Shift+wheel)" to "Taller",
        "Undo (Ctrl+Z)" to "Undo",
        "Redo (Ctrl+Shift+Z)" to "Redo",
    )

    test("in a wide window, each icon has a word beside it, and all of them fit") {
        inWindow(1920) {
            for ((button, word) in words) onNode(hasContentDescription(button) and hasText(word)).assertExists()
            for (tab in InspectorTab.entries - InspectorTab.MODULES) {
                onNodeWithText(tab.title, substring = true, useUnmergedTree = true).assertExists()
            }
            onNodeWithText(InspectorTab.MODULES.title, useUnmergedTree = true).assertDoesNotExist()
            onNodeWithContentDescription("Keys and gestures").getBoundsInRoot().run { right shouldBeLessThan 1920.dp }
            onNodeWithText(match.label).getBoundsInRoot().width shouldBeGreaterThan 260.dp
            onNodeWithContentDescription("Redo (Ctrl+Shift+Z)").getBoundsInRoot().top shouldBe
                onNodeWithContentDescription("Zoom in (+)").getBoundsInRoot().top
        }
    }

    test("the words also fit with the panel for swerve modules, in the narrowest window that has words") {
        fun lastButton(width: Int): DpRect {
            lateinit var bounds: DpRect
            inWindow(width, swerve) {
                for ((button, word) in words) onNode(hasContentDescription(button) and hasText(word)).assertExists()
                for (tab in InspectorTab.entries) onNodeWithText(tab.title, substring = true, useUnmergedTree = true).assertExists()
                bounds = onNodeWithContentDescription("Keys and gestures").getBoundsInRoot()
                onNodeWithText(swerve.label).getBoundsInRoot().width shouldBeGreaterThan 60.dp
            }
            return bounds
        }
        val (wide, narrow) = lastButton(1920) to lastButton(1700)
        narrow.width shouldBe wide.width
        narrow.right shouldBeLessThan 1700.dp
    }

    test("on a laptop, buttons show only icons, and keep their descriptions") {
        inWindow(1366) {
            for ((button, word) in words) {
                onNodeWithContentDescription(button).assertExists()
                onNode(hasContentDescription(button) and hasText(word)).assertDoesNotExist()
            }
        }
    }

    test("a live region has the cursor's place and values after a key, not after a move of the pointer") {
        val region = SemanticsMatcher.expectValue(SemanticsProperties.LiveRegion, LiveRegionMode.Polite)
        inWindow(1366, recordingOf(bagOf(listOf("Time|xaxis", "Voltage"), List(11) { "$it,${12 - it}" }))) { viewer ->
            runOnIdle {
                viewer.view.send(PlaceAction.MoveCursor(4.0))
                viewer.view.press(KeyAction.NEXT_SAMPLE)
            }
            onNode(region).assertTextEquals("5.000 V, Voltage 7 V")
            // A screen reader ignores elements without a size.
            onNode(region).fetchSemanticsNode().size.width shouldBeGreaterThan 0
            onNodeWithContentDescription("Plot Voltage").performMouseInput { moveTo(centerLeft) }
            waitForIdle()
            onNode(region).assertTextEquals("5.000 V, Voltage 7 V")
        }
    }
})
