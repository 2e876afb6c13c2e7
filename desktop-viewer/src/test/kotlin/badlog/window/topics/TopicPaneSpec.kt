package badlog.window.topics

import androidx.compose.ui.input.key.Key
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.click
import androidx.compose.ui.test.onAllNodesWithText
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.onRoot
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performKeyInput
import androidx.compose.ui.test.performMouseInput
import androidx.compose.ui.test.performTextInput
import androidx.compose.ui.test.pressKey
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import badlog.files.UserFolders
import badlog.window.TestTopics
import badlog.window.app.Viewer
import badlog.window.bagOf
import badlog.window.log.OpenRecording
import badlog.window.recordingOf
import badlog.window.theme.Theme
import badlog.window.theme.ViewerTheme
import badlog.window.waiting.waitFor
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.MainScope
import kotlinx.coroutines.launch
import java.util.concurrent.CountDownLatch

@OptIn(ExperimentalTestApi::class)
class TopicPaneSpec : FunSpec({
    val home = tempdir().toPath()

    fun viewerOf(recording: OpenRecording?) = Viewer(MainScope(), UserFolders(home, home)).apply { recording?.let(current::replace) }
    fun drawn(viewer: Viewer) = viewer.board.state.graphs.map { it.lines }

    val arm = recordingOf(
        bagOf(listOf("Time|xaxis", "Arm/Angle", "Arm/Speed", "Drive/Left", "Log|log"), listOf("0,10,1,7,", "1,20,2,8,homed", "2,30,3,9,")),
    )

    test("a click draws a topic, and a second one removes it") {
        val viewer = viewerOf(arm)
        runDesktopComposeUiTest(240, 600) {
            setContent { ViewerTheme(Theme.LIGHT) { TestTopics(viewer) } }
            waitFor { onAllNodesWithText("Speed").fetchSemanticsNodes().isNotEmpty() }
            onNodeWithContentDescription("Topic Arm/Speed").performClick()
            onNodeWithContentDescription("Topic Arm/Angle").performClick()
            runOnIdle { drawn(viewer) shouldContainExactly listOf(listOf("Arm/Speed"), listOf("Arm/Angle")) }
            onNodeWithContentDescription("Topic Arm/Speed").performClick()
            runOnIdle { drawn(viewer) shouldContainExactly listOf(listOf("Arm/Angle")) }
        }
    }

    test("several topics are selected with Ctrl, and drawn in one graph") {
        val viewer = viewerOf(arm)
        runDesktopComposeUiTest(240, 600) {
            setContent { ViewerTheme(Theme.LIGHT) { TestTopics(viewer) } }
            waitFor { onAllNodesWithText("Speed").fetchSemanticsNodes().isNotEmpty() }
            onRoot().performKeyInput { keyDown(Key.CtrlLeft) }
            onNodeWithContentDescription("Topic Drive/Left").performMouseInput { click() }
            onNodeWithContentDescription("Topic Arm/Angle").performMouseInput { click() }
            onRoot().performKeyInput { keyUp(Key.CtrlLeft) }
            onNodeWithText("2 selected").assertExists()
            onNodeWithContentDescription("New graph of the selected topics").performClick()
            runOnIdle {
                drawn(viewer) shouldContainExactly listOf(listOf("Drive/Left", "Arm/Angle"))
                viewer.topics.state.selected shouldBe emptyList()
            }
        }
    }

    test("10,000 topics and names of 500 characters are listed and searched") {
        val long = "Long ".repeat(100)
        val names = List(10_000) { "Folder ${it % 50}/Topic $it" } + long
        val viewer = viewerOf(recordingOf(bagOf(listOf("Time|xaxis") + names, listOf("0," + names.joinToString(",") { "1" }))))
        runDesktopComposeUiTest(240, 600) {
            setContent { ViewerTheme(Theme.LIGHT) { TestTopics(viewer) } }
            waitFor { onAllNodesWithText("Folder 0").fetchSemanticsNodes().isNotEmpty() }
            onNodeWithContentDescription("Topic $long").assertExists()
            onNodeWithContentDescription("Search topics").performTextInput("topic 4242")
            waitFor { viewer.topics.state.query == "topic 4242" && onAllNodesWithText("Folder 0").fetchSemanticsNodes().isEmpty() }
            onNodeWithContentDescription("Topic Folder 42/Topic 4242").assertExists()
        }
    }

    test("a key right after typing acts on the typed search, even if the list still shows the previous one") {
        val viewer = viewerOf(recordingOf(bagOf(listOf("Time|xaxis", "Drive/Speed", "Elevator/Height"), listOf("0,1,2"))))
        val listed = CountDownLatch(1)
        runDesktopComposeUiTest(240, 600) {
            setContent { ViewerTheme(Theme.LIGHT) { TestTopics(viewer) } }
            waitFor { onAllNodesWithText("Drive").fetchSemanticsNodes().isNotEmpty() }
            // Every thread that could list the topics again is busy.
            val busy = CoroutineScope(Dispatchers.Default)
            repeat(100) { busy.launch { listed.await() } }
            try {
                onNodeWithContentDescription("Search topics").performTextInput("height")
                onNodeWithContentDescription("Search topics").performKeyInput { pressKey(Key.DirectionDown) }
                viewer.topics.state.marked shouldBe "Elevator/Height"
            } finally {
                listed.countDown()
            }
        }
    }
})
