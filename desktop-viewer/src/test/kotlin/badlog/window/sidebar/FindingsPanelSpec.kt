package badlog.window.sidebar

import androidx.compose.ui.geometry.Offset
import androidx.compose.ui.semantics.SemanticsActions
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsSelected
import androidx.compose.ui.test.click
import androidx.compose.ui.test.onAllNodesWithText
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performMouseInput
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import androidx.compose.ui.text.TextLayoutResult
import badlog.viewer.input.KeyAction
import badlog.viewer.state.PlaceAction
import badlog.viewer.text.word
import badlog.window.TestInspector
import badlog.window.app.Viewer
import badlog.window.app.ViewerScreen
import badlog.window.findings.counted
import badlog.window.findings.findingsIn
import badlog.window.findings.findingsOf
import badlog.window.findings.ruleText
import badlog.window.findings.writeRules
import badlog.window.graph.savePicture
import badlog.window.graph.viewerOf
import badlog.window.graph.waitForPictures
import badlog.window.log.OpenRecording
import badlog.window.theme.Theme
import badlog.window.theme.ViewerTheme
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldNotBeEmpty
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import java.nio.file.Files
import java.nio.file.Path

@OptIn(ExperimentalTestApi::class)
@Tags("InCheck")
class FindingsPanelSpec : FunSpec({
    fun inspecting(recording: OpenRecording): Viewer = viewerOf(recording).apply {
        findings.change { withList(findingsIn(recording)) }
        panels.change { copy(inspector = InspectorTab.FINDINGS, library = false, front = FrontPart.DETAILS) }
    }

    fun folderOf(vararg rules: String): Path = tempdir().toPath().also { writeRules(it, *rules) }

    test("a click on a finding moves the cursor and the view there, and keys continue from it") {
        val recording = counted(folderOf(ruleText("Early", "A < 5", "error"), ruleText("Late", "A > 90"), ruleText("None", "X > 1")))
        val viewer = inspecting(recording)
        viewer.view.send(PlaceAction.Show(40.0, 50.0))
        runDesktopComposeUiTest(320, 600) {
            setContent { ViewerTheme(Theme.LIGHT) { TestInspector(viewer) } }
            onNodeWithText("1 error, 1 warning").assertExists()
            onNodeWithContentDescription("Finding, warning: Late").performClick()
            runOnIdle {
                viewer.view.cursor shouldBe viewer.findings.state.list?.timeline?.places?.last()?.span?.from
                (viewer.view.cursor.shouldNotBeNull() in viewer.view.viewport.visible) shouldBe true
                viewer.panels.state.front shouldBe FrontPart.GRAPHS
                viewer.view.press(KeyAction.PREVIOUS_FINDING)
            }
            onNodeWithContentDescription("Finding, error: Early").assertIsSelected()
            onNodeWithText("None").assertDoesNotExist()
            onNodeWithText("1 could not", substring = true).performClick()
            onNodeWithText("None: ", substring = true).assertExists()
        }
    }

    test("one click makes a topic a signal for all logs of the folder; an unsuitable topic is refused with a reason") {
        val folder = tempdir().toPath()
        val log = folder.resolve("a.bag")
        val header = """{"topics":[{"name":"Time","unit":"s","attrs":["xaxis"]},{"name":"Power/My Volts","unit":"V","attrs":[]},{"name":"Arm","unit":"m","attrs":[]}],"values":[]}"""
        Files.writeString(log, (listOf(header, "Time,Power/My Volts,Arm") + List(60) { "${it / 10.0},${if (it in 20..40) 6 else 12},1" }).joinToString("\n", postfix = "\n"))
        val viewer = viewerOf(OpenRecording.read(log)).apply {
            findings.change { withList(findingsOf(checkNotNull(current.recording).forRules, log, folder)) }
            panels.change { copy(inspector = InspectorTab.FINDINGS, library = false, front = FrontPart.DETAILS) }
        }
        runDesktopComposeUiTest(420, 900) {
            setContent { ViewerTheme(Theme.LIGHT) { viewer.keyboard.Watch { TestInspector(viewer) } } }
            fun choose(topic: String) {
                onNodeWithContentDescription("Choose the topic for “battery”", substring = true).performClick()
                onNodeWithText(topic).performClick()
                waitForIdle()
            }
            onNodeWithText("could not", substring = true).performClick()
            choose("Arm")
            onNodeWithText("“Arm” cannot be “battery”, which is a number in V; choose another topic.").assertExists()
            Files.exists(folder.resolve("badlog-signals.toml")) shouldBe false
            choose("Power/My Volts")
            runOnIdle { viewer.findings.state.timesAsked shouldBe 1 }
        }
        findingsOf(OpenRecording.read(log).forRules, folder.resolve("other.bag"), folder).all.map { it.rule } shouldContain "Low battery"
    }

    test("a finding that keys go to is completely visible, with its whole text") {
        val text = "What a rule says may take many lines of a panel that is narrow. ".repeat(6)
        val viewer = inspecting(counted(folderOf(*Array(12) { ruleText("Rule $it", "A > ${it * 8} and A < ${it * 8 + 3}", text = text) })))
        runDesktopComposeUiTest(320, 700) {
            setContent { ViewerTheme(Theme.LIGHT) { TestInspector(viewer) } }
            val all = viewer.findings.state.list.shouldNotBeNull().all
            for (finding in all + all.asReversed()) {
                runOnIdle { viewer.findings.goTo(finding) }
                waitForIdle()
                val line = onNodeWithContentDescription("Finding, warning: ${finding.rule}").fetchSemanticsNode()
                line.boundsInRoot.height shouldBe line.size.height.toFloat()
            }
            val layouts = ArrayList<TextLayoutResult>()
            onAllNodesWithText(text.trim(), substring = true, useUnmergedTree = true).fetchSemanticsNodes()
                .forEach { it.config[SemanticsActions.GetTextLayoutResult].action?.invoke(layouts) }
            layouts.shouldNotBeEmpty()
            layouts.forEach { it.hasVisualOverflow shouldBe false }
        }
    }

    test("sixty findings are marked on the time axis, and pointing at one shows its text") {
        val severities = listOf("error", "warning", "note")
        val rules = List(60) { ruleText("Rule $it", "A > ${it + 10} and A < ${it + 13}", severities[it % 3]) }
        val viewer = inspecting(counted(folderOf(*rules.toTypedArray())))
        runDesktopComposeUiTest(1200, 700) {
            setContent { ViewerScreen(viewer) }
            val strip = onNodeWithContentDescription("Findings on the time axis")
            for (theme in listOf(Theme.DARK, Theme.LIGHT)) {
                runOnIdle { viewer.settings.change { copy(theme = theme) } }
                waitForPictures(viewer)
                strip.performMouseInput { moveTo(Offset(width * 0.45f, height / 2f)) }
                val pointed = viewer.findings.state.pointed.shouldNotBeNull()
                onNodeWithText("${pointed.severity.word}: ${pointed.rule}").assertExists()
                savePicture("findings-${theme.name.lowercase()}")
                strip.performMouseInput { exit() }
                runOnIdle { viewer.findings.state.pointed shouldBe null }
            }
            strip.performMouseInput { moveTo(Offset(width * 0.45f, height / 2f)) }
            val pointed = viewer.findings.state.pointed.shouldNotBeNull()
            strip.performMouseInput { click(Offset(width * 0.45f, height / 2f)) }
            runOnIdle { viewer.view.cursor shouldBe pointed.time }
        }
    }
})
