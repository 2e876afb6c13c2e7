package badlog.window.export

import androidx.compose.ui.graphics.ImageBitmap
import badlog.files.UserFolders
import badlog.viewer.choices.board.defaultBoard
import badlog.viewer.state.PlaceAction
import badlog.window.app.Viewer
import badlog.window.export.figure.copyImage
import badlog.window.waiting.awaitState
import badlog.window.waiting.onWindowThread
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlinx.coroutines.MainScope
import java.awt.HeadlessException
import java.awt.Image
import java.awt.datatransfer.Clipboard
import java.awt.datatransfer.DataFlavor
import java.io.IOException

class CopyImageSpec : FunSpec({
    val home = tempdir().toPath()

    fun imageOn(clipboard: Clipboard) = clipboard.getData(DataFlavor.imageFlavor) as Image

    test("a picture is copied to the clipboard as an image") {
        val clipboard = Clipboard("test")
        copyImage(ImageBitmap(30, 20), { clipboard })
        imageOn(clipboard).getWidth(null) shouldBe 30
    }

    test("a graph is copied to the clipboard as the picture of a figure") {
        val clipboard = Clipboard("test")
        val recording = recordingOf(armBag(500))
        val viewer = Viewer(MainScope(), UserFolders(home, home))
        onWindowThread {
            viewer.current.replace(recording)
            viewer.view.send(PlaceAction.Open(recording.span))
            viewer.figures.copy(defaultBoard(recording.view).graphs.take(1)) { clipboard }
            awaitState { viewer.notices.all.isNotEmpty() }
            viewer.notices.all.single().text shouldContain "“Arm/Angle”"
            imageOn(clipboard).getWidth(null) shouldBe 1800
        }
    }

    test("a missing or busy clipboard is reported in a sentence") {
        shouldThrow<IOException> { copyImage(ImageBitmap(1, 1)) { throw HeadlessException() } }.message shouldContain "no clipboard"
        shouldThrow<IOException> { copyImage(ImageBitmap(1, 1)) { throw IllegalStateException() } }.message shouldContain "is using the clipboard"
    }
})
