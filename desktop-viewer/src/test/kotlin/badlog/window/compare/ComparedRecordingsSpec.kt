package badlog.window.compare

import androidx.compose.ui.input.key.Key
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.onAllNodesWithText
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performKeyInput
import androidx.compose.ui.test.performTextReplacement
import androidx.compose.ui.test.pressKey
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import badlog.files.UserFolders
import badlog.viewer.shown.statistics.Statistic
import badlog.viewer.state.AcrossState
import badlog.viewer.state.FolderAction
import badlog.window.app.Viewer
import badlog.window.app.ViewerScreen
import badlog.window.files.ChosenFiles
import badlog.window.files.FileChoice
import badlog.window.files.SystemFileChoice
import badlog.window.recordingOf
import badlog.window.sidebar.MainView
import badlog.window.waiting.waitFor
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.MainScope
import kotlinx.coroutines.swing.Swing
import kotlinx.coroutines.withContext
import java.nio.file.Files
import java.nio.file.Path
import kotlin.time.Duration.Companion.seconds

@OptIn(ExperimentalTestApi::class)
class ComparedRecordingsSpec : FunSpec({
    val home = tempdir().toPath()
    fun file(name: String, text: String): Path = home.resolve(name).also { Files.writeString(it, text) }

    val open = recordingOf("Time,A\n0,1\n1,2\n", home.resolve("open.bag").toString())
    val other = file("other.bag", "Time,A\n0,3\n1,9\n")

    fun viewerOf(files: FileChoice = SystemFileChoice) = Viewer(MainScope(), UserFolders(home, home), files = files).also { it.current.replace(open) }

    suspend fun <T> onWindow(action: () -> T): T = withContext(Dispatchers.Swing) { action() }

    test("a checked recording is read and drawn after the open one, until it is unchecked") {
        val viewer = onWindow { viewerOf() }
        onWindow { viewer.compared.toggle(other) }
        eventually(60.seconds) { onWindow { viewer.compared.drawn.map { it.recording.file } } shouldContainExactly listOf(open.file, other) }
        onWindow { viewer.compared.toggle(other) }
        onWindow { viewer.compared.state } shouldBe Comparison()
    }

    test("the open recording can be checked without being read again, and is drawn once") {
        val viewer = onWindow { viewerOf() }
        onWindow {
            viewer.compared.toggle(open.file)
            viewer.tasks.all.isEmpty() shouldBe true
            viewer.compared.state.loaded[open.file] shouldBe open
            viewer.compared.drawn shouldBe listOf(DrawnRecording(open))
        }
    }

    test("an unreadable recording is reported and unchecked") {
        val viewer = onWindow { viewerOf() }
        onWindow {
            viewer.compared.toggle(home.resolve("missing.bag"))
            viewer.compared.toggle(file("picture.bag", "\u0089PNG\r\n\u001a\n\u0000\u0000"))
        }
        eventually(60.seconds) {
            onWindow { viewer.compared.state.checked } shouldBe emptyList()
            onWindow { viewer.notices.all.map { it.isError } } shouldBe listOf(true, true)
        }
    }

    test("a compared recording is moved by hand, and the table of statistics is saved") {
        val saved = home.resolve("table.csv")
        val viewer = viewerOf(ChosenFiles(saved))
        val read = recordingOf(Files.readString(other), other.toString())
        viewer.compared.change { Comparison().with(other).withLoaded(read) }
        viewer.view.send(FolderAction.MeasureAcross(AcrossState(listOf("A"), setOf(Statistic.MAX))))
        runDesktopComposeUiTest(1300, 700) {
            setContent { ViewerScreen(viewer) }
            onNodeWithContentDescription("Move other.bag by +0.1").performClick()
            onNodeWithContentDescription("Move other.bag by +1").performClick()
            runOnIdle { viewer.compared.drawn[1].offset shouldBe 1.1 }
            onNodeWithContentDescription("Offset of other.bag").performTextReplacement("-2,5")
            onNodeWithContentDescription("Offset of other.bag").performKeyInput { pressKey(Key.Enter) }
            runOnIdle { viewer.compared.drawn[1].offset shouldBe -2.5 }
            viewer.panels.change { copy(main = MainView.STATISTICS) }
            waitFor { onAllNodesWithText("9").fetchSemanticsNodes().isNotEmpty() }
            onNodeWithContentDescription("Save the table as CSV").performClick()
            waitFor { viewer.notices.all.isNotEmpty() }
        }
        Files.readString(saved) shouldContain "Log,Date,File,A max\r\nopen.bag,"
    }
})
