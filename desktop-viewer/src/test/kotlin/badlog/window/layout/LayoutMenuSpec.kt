package badlog.window.layout

import androidx.compose.ui.test.ComposeUiTest
import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.assertIsNotEnabled
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import badlog.core.analysis.Span
import badlog.files.UserFolders
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.defaultBoard
import badlog.viewer.input.KeyAction
import badlog.viewer.state.PlaceAction
import badlog.window.app.Viewer
import badlog.window.app.ViewerScreen
import badlog.window.export.armBag
import badlog.window.export.recordingOf
import badlog.window.files.ChosenFiles
import badlog.window.waiting.waitFor
import badlog.window.waiting.waitForNotice
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import kotlinx.coroutines.MainScope
import java.nio.file.Files

@OptIn(ExperimentalTestApi::class)
@Tags("InCheck")
class LayoutMenuSpec : FunSpec({
    val home = tempdir().toPath()
    val log = Files.writeString(home.resolve("match.bag"), armBag(500))
    val recording = recordingOf(armBag(500), log)

    fun ComposeUiTest.choose(entry: String) {
        onNodeWithText("Layout").performClick()
        onNodeWithContentDescription(entry).performClick()
    }

    test("without a log, the entries for layouts are disabled") {
        runDesktopComposeUiTest(1200, 800) {
            setContent { ViewerScreen(Viewer(MainScope(), UserFolders(home, home))) }
            onNodeWithText("Layout").performClick()
            onNodeWithContentDescription("Save the layout as…").assertIsNotEnabled()
            onNodeWithContentDescription("Start board").assertIsNotEnabled()
        }
    }

    test("a dropped layout is ignored without a log, and a log dropped with it is opened") {
        val viewer = Viewer(MainScope(), UserFolders(home, home))
        val layout = home.resolve("dropped${Layout.ENDING}")
        viewer.openDropped(listOf(layout))
        viewer.notices.all.single().text shouldBe "Open a log first."
        viewer.loader.isReading shouldBe false
        viewer.openDropped(listOf(layout, log))
        viewer.library.state.folder shouldBe home
    }

    test("a layout is saved and opened, the start board is restored, and a file that is not a layout is reported") {
        val file = home.resolve("mine${Layout.ENDING}")
        val files = ChosenFiles(file)
        runDesktopComposeUiTest(1200, 800) {
            val viewer = Viewer(MainScope(), UserFolders(home, home), files = files)
            viewer.current.replace(recording)
            viewer.board.replace(Board().withGraph(listOf("Arm/Current")))
            viewer.view.send(PlaceAction.Open(recording.span))
            setContent { ViewerScreen(viewer) }
            choose("Save the layout as…")
            waitForNotice(viewer, "Saved the layout to $file")
            choose("Start board")
            waitForIdle()
            viewer.board.state shouldBe defaultBoard(recording.view)
            choose("Open a layout…")
            waitFor { viewer.board.state.graphs.size == 1 }
            viewer.board.state.graphs.single().title shouldBe "Arm/Current"
            files.file = log
            choose("Open a layout…")
            waitForNotice(viewer, "match.bag is not a layout")
        }
    }

    test("layouts saved beside the logs are in the menu, and keys go through them without leaving the place in the log") {
        val folder = tempdir().toPath()
        val own = Files.writeString(folder.resolve("match.bag"), armBag(500))
        val files = ChosenFiles(folder.resolve("Power${Layout.ENDING}"))
        runDesktopComposeUiTest(1200, 800) {
            val viewer = Viewer(MainScope(), UserFolders(home, home), files = files)
            val open = recordingOf(armBag(500), own)
            viewer.current.replace(open)
            viewer.board.replace(Board())
            viewer.view.send(PlaceAction.Open(open.span))
            setContent { ViewerScreen(viewer) }
            viewer.view.press(KeyAction.NEXT_LAYOUT)
            waitForNotice(viewer, "No layout is kept yet; Ctrl+S saves one beside the logs, such as “Power” or “Drive”.")
            fun keep(name: String, line: String) {
                files.file = folder.resolve(name + Layout.ENDING)
                runOnIdle { viewer.board.replace(Board().withGraph(listOf(line))) }
                choose("Save the layout as…")
                waitFor { name in viewer.keptLayouts.state.files }
            }
            keep("Power", "Arm/Current")
            keep("Arm", "Arm/Angle")
            runOnIdle {
                viewer.view.send(PlaceAction.Show(1.0, 2.0))
                viewer.view.press(KeyAction.NEXT_LAYOUT)
            }
            waitFor { viewer.board.state.graphs.single().title == "Arm/Current" }
            viewer.view.viewport.visible shouldBe Span(1.0, 2.0)
            runOnIdle { viewer.view.press(KeyAction.NEXT_LAYOUT) }
            waitFor { viewer.board.state.graphs.single().title == "Arm/Angle" }
            choose("Power")
            waitFor { viewer.board.state.graphs.single().title == "Arm/Current" }
            runOnIdle { viewer.board.undo() }
            viewer.board.state.graphs.single().title shouldBe "Arm/Angle"
        }
    }
})
