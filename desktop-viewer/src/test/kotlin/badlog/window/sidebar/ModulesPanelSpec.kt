package badlog.window.sidebar

import androidx.compose.ui.graphics.toPixelMap
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.captureToImage
import androidx.compose.ui.test.onAllNodesWithContentDescription
import androidx.compose.ui.test.onAllNodesWithText
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performScrollTo
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import badlog.files.UserFolders
import badlog.viewer.input.KeyAction
import badlog.viewer.state.PlaceAction
import badlog.window.TestInspector
import badlog.window.app.Viewer
import badlog.window.bagOf
import badlog.window.log.OpenRecording
import badlog.window.recordingOf
import badlog.window.theme.Palette
import badlog.window.theme.Theme
import badlog.window.theme.ViewerTheme
import badlog.window.waiting.waitFor
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import kotlinx.coroutines.MainScope
import kotlin.math.PI

@OptIn(ExperimentalTestApi::class)
class ModulesPanelSpec : FunSpec({
    val home = tempdir().toPath()

    /** Returns ten seconds of three modules; module 1 points 10° aside, and 15° from 3 s to 3.5 s. */
    fun drive(hasTargets: Boolean): OpenRecording {
        val sides = if (hasTargets) listOf("Measured", "Setpoints") else listOf("Measured")
        val topics = sides.flatMap { side -> List(3) { "$side[$it]" } }.flatMap { listOf("$it/speed", "$it/angle/value") }
        val rows = List(501) { row ->
            val time = row / 50.0
            val numbers = topics.map { topic ->
                val off = (if (time in 3.0..3.5) 15 else 10).takeIf { topic.startsWith("Measured[1]") } ?: 0
                if (topic.endsWith("speed")) 2.0 else time / 5 + off * PI / 180
            }
            (listOf(time) + numbers).joinToString(",")
        }
        return recordingOf(bagOf(listOf("Time|xaxis") + topics, rows), "targets-$hasTargets.bag")
    }

    fun viewerOf(recording: OpenRecording) = Viewer(MainScope(), UserFolders(home, home)).apply {
        current.replace(recording)
        view.send(PlaceAction.Open(recording.span))
    }

    test("the worst module is named, its largest error moves the cursor there, and the arrows have the modules' colors") {
        val viewer = viewerOf(drive(hasTargets = true))
        viewer.panels.change { inspecting(InspectorTab.MODULES) }
        runDesktopComposeUiTest(340, 800) {
            setContent { ViewerTheme(Theme.LIGHT) { TestInspector(viewer) } }
            val sentence = "Module 1 has the largest angle error: 10.3° RMS, the others 0.0°."
            waitFor { onAllNodesWithText(sentence).fetchSemanticsNodes().isNotEmpty() }
            onNodeWithContentDescription("largest 15.0°: Go to the largest error, at 3.000", substring = true).performScrollTo().performClick()
            runOnIdle { viewer.view.cursor shouldBe 3.0 }
            val pixels = onNodeWithContentDescription("Modules at the cursor").performScrollTo().captureToImage().toPixelMap()
            val ofModule = (0 until pixels.height).sumOf { y -> (0 until pixels.width).count { pixels[it, y] == Palette.LIGHT.line(2) } }
            ofModule shouldBeGreaterThan 50
            viewer.view.send(PlaceAction.Show(3.1, 3.4))
            waitFor { onAllNodesWithText("15.0° RMS").fetchSemanticsNodes().isNotEmpty() }
            // A log that has grown has its previous numbers until the new ones are known.
            runOnIdle { viewer.current.replace(drive(hasTargets = true)) }
            waitForIdle()
            (onAllNodesWithText("RMS", substring = true).fetchSemanticsNodes().size > 0) shouldBe true
            // Another log never has the previous log's numbers.
            runOnIdle { viewer.current.replace(drive(hasTargets = false)) }
            waitForIdle()
            onAllNodesWithText("RMS", substring = true).fetchSemanticsNodes().size shouldBe 0
            waitFor { onAllNodesWithText("This log has no targets", substring = true).fetchSemanticsNodes().isNotEmpty() }
        }
    }

    test("without modules, the button is missing, and the panel has the reason") {
        val none = viewerOf(recordingOf(bagOf(listOf("Time|xaxis", "A"), listOf("0,1"))))
        none.view.press(KeyAction.MODULES)
        runDesktopComposeUiTest(420, 800) {
            setContent { ViewerTheme(Theme.DARK) { TestInspector(none) } }
            onNodeWithText("This log has no swerve modules", substring = true).assertExists()
            onAllNodesWithContentDescription("Show modules").fetchSemanticsNodes().size shouldBe 0
        }
    }
})
