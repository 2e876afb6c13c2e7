package badlog.window.app

import androidx.compose.foundation.lazy.LazyListState
import androidx.compose.ui.test.DesktopComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.hasContentDescription
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performTextInput
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import badlog.files.UserFolders
import badlog.window.bagOf
import badlog.window.export.recordingOf
import badlog.window.sidebar.Panels
import badlog.window.theme.Theme
import badlog.window.waiting.waitFor
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import kotlinx.coroutines.MainScope

@OptIn(ExperimentalTestApi::class)
@Tags("InCheck")
class ViewerScreenSpec : FunSpec({
    val folder = tempdir().toPath()

    fun log(name: String, topics: Int) = recordingOf(
        bagOf(listOf("Time|xaxis") + List(topics) { "Topic $it" }, List(3) { row -> "$row," + List(topics) { "${it + row}" }.joinToString(",") }),
        folder.resolve(name),
    )

    val large = log("large.bag", 200)
    val small = log("small.bag", 60)

    fun inWindow(steps: DesktopComposeUiTest.(Viewer) -> Unit) {
        val viewer = Viewer(MainScope(), UserFolders(folder, folder))
        runDesktopComposeUiTest(1366, 768) {
            setContent { ViewerScreen(viewer) }
            steps(viewer)
        }
    }

    fun DesktopComposeUiTest.awaitTopic(name: String) = waitFor { onAllNodes(hasContentDescription("Topic $name")).fetchSemanticsNodes().isNotEmpty() }

    fun at(list: LazyListState) = list.firstVisibleItemIndex to list.firstVisibleItemScrollOffset

    fun DesktopComposeUiTest.scroll(list: LazyListState, item: Int, offset: Int) {
        runOnUiThread { list.requestScrollToItem(item, offset) }
        waitFor { at(list) == item to offset }
    }

    test("each log keeps its search and scroll position; another log begins at its top") {
        inWindow { viewer ->
            runOnUiThread { viewer.show(large) }
            awaitTopic("Topic 0")
            scroll(viewer.topics.list, 150, 7)
            scroll(viewer.graphs.list, 10, 5)
            runOnUiThread { viewer.show(small) }
            awaitTopic("Topic 0")
            waitFor { at(viewer.topics.list) == 0 to 0 && at(viewer.graphs.list) == 0 to 0 }
            onNodeWithContentDescription("Search topics").performTextInput("topic 5")
            waitFor { viewer.topics.state.query == "topic 5" }
            runOnUiThread { viewer.show(large) }
            awaitTopic("Topic 150")
            viewer.topics.state.query shouldBe ""
            waitFor { at(viewer.topics.list) == 150 to 7 && at(viewer.graphs.list) == 10 to 5 }
            runOnUiThread { viewer.show(small) }
            awaitTopic("Topic 5")
            viewer.topics.state.query shouldBe "topic 5"
            onNodeWithContentDescription("Topic Topic 4").assertDoesNotExist()
        }
    }

    test("on a small laptop, open findings take the place of the topics until they are closed") {
        inWindow { viewer ->
            runOnUiThread { viewer.show(small) }
            awaitTopic("Topic 0")
            onNodeWithContentDescription("Findings").performClick()
            onNodeWithContentDescription("Topic Topic 0").assertDoesNotExist()
            // There once were 355 pixels left between the axes.
            onNodeWithContentDescription("Overview").fetchSemanticsNode().size.width shouldBeGreaterThan 600
            onNodeWithContentDescription("Findings").performClick()
            onNodeWithContentDescription("Topic Topic 0").assertExists()
            viewer.panels.state shouldBe Panels()
        }
    }

    test("a theme chosen under other system colors switches to the opposite colors") {
        Theme.DARK.other(isSystemDark = true) shouldBe Theme.LIGHT
        Theme.LIGHT.other(isSystemDark = true) shouldBe Theme.SYSTEM
        Theme.LIGHT.other(isSystemDark = false) shouldBe Theme.DARK
    }
})
