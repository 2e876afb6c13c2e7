package badlog.window.app

import androidx.compose.ui.test.DesktopComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsFocused
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import badlog.files.UserFolders
import badlog.window.bagOf
import badlog.window.recordingOf
import badlog.window.sidebar.InspectorTab
import badlog.window.sidebar.Panels
import badlog.window.topics.toggleDrawn
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import kotlinx.coroutines.MainScope

@OptIn(ExperimentalTestApi::class)
@Tags("InCheck")
class FoldedTopicsSpec : FunSpec({
    fun inWindow(width: Int, steps: DesktopComposeUiTest.(Viewer) -> Unit) {
        val home = tempdir().toPath()
        val viewer = Viewer(MainScope(), UserFolders(home, home))
        viewer.show(recordingOf(bagOf(listOf("Time|xaxis", "Arm/Angle", "Log|log"), listOf("0,10,", "1,20,homed", "2,30,"))))
        runDesktopComposeUiTest(width, 768) {
            setContent { ViewerScreen(viewer) }
            steps(viewer)
        }
    }

    fun DesktopComposeUiTest.findings() = onNodeWithContentDescription("Findings").performClick()

    fun DesktopComposeUiTest.hasTopics(has: Boolean) = onNodeWithContentDescription("Topic Arm/Angle").run { if (has) assertExists() else assertDoesNotExist() }

    test("on a small laptop, open findings take the place of the topics until they are closed") {
        inWindow(1366) { viewer ->
            hasTopics(true)
            findings()
            hasTopics(false)
            // There once were 355 pixels left between the axes.
            onNodeWithContentDescription("Overview").fetchSemanticsNode().size.width shouldBeGreaterThan 600
            findings()
            hasTopics(true)
            viewer.panels.state shouldBe Panels()
        }
    }

    test("topics opened beside the findings stay until the findings are opened again") {
        inWindow(1366) { viewer ->
            findings()
            onNodeWithContentDescription("Topics").performClick()
            hasTopics(true)
            onNodeWithContentDescription("Show notes").performClick()
            hasTopics(true)
            onNodeWithContentDescription("Close the panel").performClick()
            hasTopics(true)
            findings()
            hasTopics(false)
            askForTopics(viewer.topics, viewer.panels)
            hasTopics(true)
            onNodeWithContentDescription("Search topics").assertIsFocused()
            onNodeWithContentDescription("Topics").performClick()
            hasTopics(false)
            findings()
            hasTopics(false)
        }
    }

    test("events opened from the topics leave the topics open") {
        inWindow(1366) { viewer ->
            val events = checkNotNull(viewer.current.recording?.signal("Log"))
            toggleDrawn(viewer.current, viewer.board, viewer.events, viewer.panels, events)
            viewer.panels.state.inspector shouldBe InspectorTab.EVENTS
            hasTopics(true)
        }
    }

    test("the topics stay if there is room for all parts, or without the list of logs") {
        inWindow(1760) {
            findings()
            hasTopics(true)
        }
        inWindow(1366) {
            onNodeWithContentDescription("Logs: the list at the left").performClick()
            findings()
            hasTopics(true)
        }
    }
})
