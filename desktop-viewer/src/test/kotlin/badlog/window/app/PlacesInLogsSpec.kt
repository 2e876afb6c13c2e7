package badlog.window.app

import androidx.compose.foundation.lazy.LazyListState
import androidx.compose.ui.test.DesktopComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.hasContentDescription
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.performTextInput
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import badlog.files.UserFolders
import badlog.viewer.choices.board.Board
import badlog.window.bagOf
import badlog.window.export.recordingOf
import badlog.window.waiting.waitFor
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import kotlinx.coroutines.MainScope

@OptIn(ExperimentalTestApi::class)
@Tags("InCheck")
class PlacesInLogsSpec : FunSpec({
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

    test("the graphs of a finding do not count for the scroll position of a log") {
        inWindow { viewer ->
            runOnUiThread { viewer.show(large) }
            awaitTopic("Topic 0")
            runOnUiThread { viewer.board.showEvidence(Board().withGraph(listOf("Topic 7", "Topic 8"))) }
            waitForIdle()
            scroll(viewer.graphs.list, 11, 5)
            runOnUiThread { viewer.show(small) }
            runOnUiThread { viewer.show(large) }
            waitFor { at(viewer.graphs.list) == 10 to 5 }
        }
    }

    test("a closed log begins at its top, without a search") {
        inWindow { viewer ->
            runOnUiThread { viewer.show(large) }
            awaitTopic("Topic 0")
            onNodeWithContentDescription("Search topics").performTextInput("topic 5")
            waitFor { viewer.topics.state.query == "topic 5" }
            runOnUiThread { viewer.show(small) }
            awaitTopic("Topic 0")
            runOnUiThread { viewer.show(large) }
            waitFor { viewer.topics.state.query == "topic 5" }
            runOnUiThread { viewer.logActions.closeLog() }
            waitForIdle()
            runOnUiThread { viewer.show(large) }
            awaitTopic("Topic 0")
            viewer.topics.state.query shouldBe ""
        }
    }
})
