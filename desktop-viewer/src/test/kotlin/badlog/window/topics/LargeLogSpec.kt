package badlog.window.topics

import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.onAllNodesWithContentDescription
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performTextInput
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import badlog.core.analysis.LogView
import badlog.formats.wpilog.largeLog
import badlog.formats.wpilog.parseLog
import badlog.viewer.choices.note.Note
import badlog.viewer.choices.note.Notebook
import badlog.viewer.state.PlaceAction
import badlog.window.TestTopics
import badlog.window.graph.TestGraphs
import badlog.window.graph.savePicture
import badlog.window.graph.viewerOf
import badlog.window.graph.waitForPictures
import badlog.window.log.OpenRecording
import badlog.window.log.StoredNotes
import badlog.window.theme.Theme
import badlog.window.theme.ViewerTheme
import badlog.window.waiting.waitFor
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import java.nio.file.Path

@OptIn(ExperimentalTestApi::class)
class LargeLogSpec : FunSpec({
    val large by lazy { OpenRecording(Path.of("large.wpilog").toAbsolutePath(), LogView.of(parseLog(largeLog()))) }

    test("a log of more than 700 topics begins with at most 60 graphs, modules and axes together, and lists all its topics") {
        large.view.recording.topics.size shouldBeGreaterThan 700
        val graphs = large.standardGraphs.graphs
        graphs.size shouldBeLessThanOrEqual 60
        graphs.map { it.title } shouldContain "Chassis/Module speeds"
        large.signals.size + large.empty.size shouldBe large.view.recording.topics.size
    }

    test("one search and one click compare target and actual speed of a swerve module") {
        val viewer = viewerOf(large).apply { board.replace(large.standardGraphs) }
        runDesktopComposeUiTest(300, 700) {
            setContent { ViewerTheme(Theme.LIGHT) { TestTopics(viewer) } }
            onNodeWithContentDescription("Search topics").performTextInput("frontleft speed")
            waitFor {
                onAllNodesWithContentDescription("Topic /Chassis/ActualFrontLeftModuleState/speed").fetchSemanticsNodes().isNotEmpty()
            }
            val before = viewer.board.state.graphs
            onNodeWithContentDescription("Topic /Chassis/ActualFrontLeftModuleState/speed").performClick()
            runOnIdle {
                (viewer.board.state.graphs - before.toSet()).map { it.lines } shouldBe
                    listOf(listOf("/Chassis/ActualFrontLeftModuleState/speed", "/Chassis/TargetFrontLeftModuleState/speed"))
            }
        }
    }

    test("the graphs of a large log are drawn, with a note at its place") {
        val viewer = viewerOf(large).apply {
            board.replace(large.standardGraphs)
            notes.change { StoredNotes(notebook = Notebook(listOf(Note(4.0, "hit by 254")))) }
            view.send(PlaceAction.MoveCursor(4.0))
        }
        runDesktopComposeUiTest(1006, 600) {
            setContent { TestGraphs(viewer) }
            waitForPictures(viewer)
            onNodeWithText("hit by 254").assertExists()
            savePicture("large-log")
        }
    }

    test("a topic without samples is found, and shown as empty") {
        val viewer = viewerOf(large)
        runDesktopComposeUiTest(300, 700) {
            setContent { ViewerTheme(Theme.LIGHT) { TestTopics(viewer) } }
            onNodeWithContentDescription("Search topics").performTextInput("camera 27/inputsave")
            waitFor { onAllNodesWithContentDescription("Topic NT:/photonvision/camera 27/inputSaveImgCmd").fetchSemanticsNodes().isNotEmpty() }
            onNodeWithText("no samples").assertExists()
        }
    }
})
