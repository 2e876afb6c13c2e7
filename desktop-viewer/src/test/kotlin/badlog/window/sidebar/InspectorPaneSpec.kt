package badlog.window.sidebar

import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsSelected
import androidx.compose.ui.test.onAllNodesWithContentDescription
import androidx.compose.ui.test.onAllNodesWithText
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performTextInput
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import badlog.core.recording.Severity
import badlog.files.UserFolders
import badlog.viewer.choices.board.Board
import badlog.viewer.state.PlaceAction
import badlog.window.TestInspector
import badlog.window.app.Viewer
import badlog.window.bagOf
import badlog.window.log.OpenRecording
import badlog.window.recordingOf
import badlog.window.theme.Theme
import badlog.window.theme.ViewerTheme
import badlog.window.waiting.waitFor
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import kotlinx.coroutines.MainScope

@OptIn(ExperimentalTestApi::class)
@Tags("InCheck")
class InspectorPaneSpec : FunSpec({
    val home = tempdir().toPath()

    fun viewerOf(recording: OpenRecording, tab: InspectorTab) = Viewer(MainScope(), UserFolders(home, home)).apply {
        current.replace(recording)
        view.send(PlaceAction.Open(recording.span))
        panels.change { copy(inspector = tab) }
    }

    test("a click on an event moves the cursor and the view to it; the cursor marks the nearest one") {
        val rows = List(100_000) { "$it,event $it" }
        val viewer = viewerOf(recordingOf(bagOf(listOf("Time|xaxis", "Log|log"), rows)), InspectorTab.EVENTS)
        viewer.view.send(PlaceAction.Show(50_000.0, 50_010.0))
        viewer.panels.change { copy(front = FrontPart.DETAILS) }
        runDesktopComposeUiTest(320, 600) {
            setContent { ViewerTheme(Theme.LIGHT) { TestInspector(viewer) } }
            waitFor { onAllNodesWithText("event 3").fetchSemanticsNodes().isNotEmpty() }
            onNodeWithContentDescription("Event at 3: event 3").performClick()
            runOnIdle {
                viewer.view.cursor shouldBe 3.0
                (3.0 in viewer.view.viewport.visible) shouldBe true
                viewer.panels.state.front shouldBe FrontPart.GRAPHS
            }
            viewer.view.send(PlaceAction.MoveCursor(77_777.4))
            waitFor { onAllNodesWithText("event 77777").fetchSemanticsNodes().isNotEmpty() }
            onNodeWithContentDescription("Event at 77777: event 77777").assertIsSelected()
            onNodeWithContentDescription("Search events").performTextInput("event 99999")
            onNodeWithText("1 of 100 000 events").assertExists()
        }
    }

    test("the badge of problems does not count notes, which healthy logs have as well") {
        val healthy = recordingOf("A,On\n1,true\n2,\n").view
        (healthy.problems.size > 0) shouldBe true
        problemsIn(healthy) shouldBe healthy.problems.count { it.severity != Severity.NOTE }
        problemsIn(recordingOf("A,B\n1,2\n3,x,y,z\n1,2\n").view) shouldBe
            recordingOf("A,B\n1,2\n3,x,y,z\n1,2\n").view.problems.count { it.severity != Severity.NOTE }
    }

    test("the panel of values draws a topic that a search finds, and then leads to its graph") {
        val viewer = viewerOf(recordingOf(bagOf(listOf("Time|xaxis", "A", "Bus"), listOf("0,1,4", "1,2,5"))), InspectorTab.CURSOR)
        viewer.board.replace(Board().withGraph(listOf("A")))
        viewer.view.send(PlaceAction.MoveCursor(1.0))
        runDesktopComposeUiTest(320, 600) {
            setContent { ViewerTheme(Theme.LIGHT) { TestInspector(viewer) } }
            waitFor { onAllNodesWithContentDescription("Go to the graph of A").fetchSemanticsNodes().isNotEmpty() }
            onNodeWithContentDescription("Search topics").performTextInput("bus")
            waitFor { onAllNodesWithContentDescription("Draw Bus").fetchSemanticsNodes().isNotEmpty() }
            onNodeWithContentDescription("Draw Bus").performClick()
            waitFor { onAllNodesWithContentDescription("Go to the graph of Bus").fetchSemanticsNodes().isNotEmpty() }
            viewer.board.state.graphs.map { it.lines } shouldBe listOf(listOf("A"), listOf("Bus"))
            onNodeWithContentDescription("Go to the graph of Bus").performClick()
            viewer.board.wanted shouldBe viewer.board.state.graphs.last().id
        }
    }

    test("each panel opens on a recording of one row, of nothing, and of long names") {
        val long = "Name ".repeat(100)
        val odd = listOf(
            bagOf(listOf("Time|xaxis", "A"), listOf("0,1")),
            "",
            bagOf(listOf("Time|xaxis", long, "$long 2|log"), listOf("0,1,$long", "NaN,2,$long"), mapOf(long to long)),
        )
        for (text in odd) {
            val viewer = viewerOf(recordingOf(text), InspectorTab.entries.first())
            viewer.board.replace(Board().withGraph(listOf(long, "A")))
            runDesktopComposeUiTest(320, 600) {
                setContent { ViewerTheme(Theme.DARK) { TestInspector(viewer) } }
                for (tab in InspectorTab.entries) {
                    runOnIdle { viewer.panels.change { copy(inspector = tab) } }
                    waitForIdle()
                    onNodeWithText(tab.title).assertExists()
                }
            }
        }
    }
})
