package badlog.window.folder

import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertCountEquals
import androidx.compose.ui.test.onAllNodesWithContentDescription
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import badlog.catalog.folder.LogEntry
import badlog.catalog.folder.putSamples
import badlog.core.recording.Severity
import badlog.files.LogFile
import badlog.files.UserFolders
import badlog.rules.Finding
import badlog.viewer.catalog.Content
import badlog.viewer.catalog.DateSource
import badlog.viewer.catalog.FindingSummary
import badlog.viewer.catalog.LogDate
import badlog.viewer.catalog.LogSummary
import badlog.viewer.shown.finding.RuleResults
import badlog.viewer.shown.folder.Changes
import badlog.window.app.Viewer
import badlog.window.app.ViewerScreen
import badlog.window.sidebar.InspectorTab
import badlog.window.waiting.waitFor
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldHaveSize
import io.kotest.matchers.shouldBe
import kotlinx.coroutines.MainScope

@OptIn(ExperimentalTestApi::class)
class SinceLastMatchSpec : FunSpec({
    test("a click on a difference shows it over the previous match") {
        val home = tempdir().toPath()
        val folder = tempdir().toPath().also { it.putSamples() }
        val viewer = Viewer(MainScope(), UserFolders(home, home))
        val summary = LogSummary(date = LogDate(0, DateSource.VALUES), content = Content.SOMETHING)
        val before = LogEntry(LogFile(folder.resolve("practice.bag"), 1, 1), summary, FindingSummary(0, emptyList()))
        runDesktopComposeUiTest(1366, 768) {
            setContent { ViewerScreen(viewer) }
            viewer.loader.open(folder.resolve("qualification-42.bag"))
            waitFor { viewer.current.recording != null }
            viewer.findings.change { withList(RuleResults(ran = 0)) }
            viewer.panels.change { inspecting(InspectorTab.FINDINGS) }
            waitForIdle()
            onAllNodesWithContentDescription("Unlike the matches before").assertCountEquals(0)
            val hot = Finding("Unlike other matches", Severity.WARNING, "Arm/Angle", "The arm was hot.", Double.NaN, emptyList(), 1, "")
            viewer.since.change { Changes(listOf(hot), mapOf(hot to before)) }
            onNodeWithText("The arm was hot.").performClick()
            waitFor { viewer.compared.state.loaded.isNotEmpty() }
            viewer.compared.state.checked shouldBe listOf(before.file)
            viewer.board.evidence.graphs.shouldHaveSize(1).single().lines.first() shouldBe "Arm/Angle"
        }
    }
})
