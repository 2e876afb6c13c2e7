package badlog.window.layout

import badlog.core.analysis.Span
import badlog.files.UserFolders
import badlog.viewer.choices.board.Board
import badlog.viewer.choices.board.defaultBoard
import badlog.viewer.input.KeyAction
import badlog.viewer.state.PlaceAction
import badlog.window.app.Viewer
import badlog.window.export.armBag
import badlog.window.export.recordingOf
import badlog.window.files.ChosenFiles
import badlog.window.waiting.awaitState
import badlog.window.waiting.onWindowThread
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import kotlinx.coroutines.MainScope
import java.nio.file.Files

class LayoutFilesSpec : FunSpec({
    val home = tempdir().toPath()
    val log = Files.writeString(home.resolve("match.bag"), armBag(500))
    val recording = recordingOf(armBag(500), log)

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
        val viewer = Viewer(MainScope(), UserFolders(home, home), files = files)
        onWindowThread {
            viewer.current.replace(recording)
            viewer.board.replace(Board().withGraph(listOf("Arm/Current")))
            viewer.view.send(PlaceAction.Open(recording.span))

            suspend fun awaitNotice(text: String) = awaitState { viewer.notices.all.any { text in it.text } }
            viewer.layoutFiles.save()
            awaitNotice("Saved the layout to $file")
            viewer.layouts.showStartBoard()
            viewer.board.state shouldBe defaultBoard(recording.view)
            viewer.layoutFiles.open()
            awaitState { viewer.board.state.graphs.singleOrNull()?.title == "Arm/Current" }
            files.file = log
            viewer.layoutFiles.open()
            awaitNotice("match.bag is not a layout")
        }
    }

    test("keys go through the layouts saved beside the logs, without leaving the place in the log") {
        val folder = tempdir().toPath()
        val own = Files.writeString(folder.resolve("match.bag"), armBag(500))
        val files = ChosenFiles(null)
        val viewer = Viewer(MainScope(), UserFolders(home, home), files = files)
        val open = recordingOf(armBag(500), own)
        onWindowThread {
            viewer.current.replace(open)
            viewer.board.replace(Board())
            viewer.view.send(PlaceAction.Open(open.span))
            viewer.view.press(KeyAction.NEXT_LAYOUT)
            awaitState { viewer.notices.all.any { it.text == "No layout is kept yet; Ctrl+S saves one beside the logs, such as “Power” or “Drive”." } }
            for ((name, line) in listOf("Power" to "Arm/Current", "Arm" to "Arm/Angle")) {
                files.file = folder.resolve(name + Layout.ENDING)
                viewer.board.replace(Board().withGraph(listOf(line)))
                viewer.layoutFiles.save()
                awaitState { name in viewer.keptLayouts.state.files }
            }
            viewer.view.send(PlaceAction.Show(1.0, 2.0))
            viewer.view.press(KeyAction.NEXT_LAYOUT)
            awaitState { viewer.board.state.graphs.single().title == "Arm/Current" }
            viewer.view.viewport.visible shouldBe Span(1.0, 2.0)
            viewer.keptLayouts.show("Arm")
            awaitState { viewer.board.state.graphs.single().title == "Arm/Angle" }
            viewer.board.undo()
            viewer.board.state.graphs.single().title shouldBe "Arm/Current"
        }
    }
})
