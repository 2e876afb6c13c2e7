package badlog.window.choice

import badlog.files.UserFolders
import badlog.viewer.draw.path.FieldFile
import badlog.window.app.Viewer
import badlog.window.files.ChosenFiles
import badlog.window.graph.choosing
import badlog.window.graph.graphActions
import badlog.window.log.OpenRecording
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldEndWith
import kotlinx.coroutines.MainScope
import java.awt.image.BufferedImage
import java.io.File
import java.nio.file.Files
import java.nio.file.Path
import javax.imageio.ImageIO

class FieldChoiceSpec : FunSpec({
    /** Returns a field in a folder of its own, with this [length] in m. */
    fun fieldOf(length: Int): Path = tempdir().let { folder ->
        ImageIO.write(BufferedImage(40, 20, BufferedImage.TYPE_INT_RGB), "png", File(folder, "f.png"))
        val text = """{"field-image":"f.png","field-corners":{"top-left":[0,0],"bottom-right":[40,20]},"field-size":[$length,8],"field-unit":"m"}"""
        File(folder, "ours.json").apply { writeText(text) }.toPath()
    }

    fun viewerOf(files: ChosenFiles, log: Path) = tempdir().toPath().let { home ->
        Viewer(MainScope(), UserFolders(home, home), files = files).apply {
            current.replace(OpenRecording.read(log))
            board.replace(checkNotNull(current.recording).standardGraphs)
        }
    }

    fun log(folder: Path = tempdir().toPath()): Path = Files.copy(Path.of("..", "samples", "wrong-turn.bag"), folder.resolve("a.bag"))

    fun Viewer.fieldLength() = checkNotNull(current.recording?.paths?.plotOf(board.state.graphs[0].lines)).field.length

    fun Viewer.menu() = graphActions(graphs, board.state.graphs[0]).flatten().filter { "field file" in it.label }

    test("a field is selected in the menu of a path, remembered for the folder, and deselected there") {
        val file = fieldOf(20)
        val viewer = viewerOf(ChosenFiles(file), log())
        val plain = viewer.fieldLength()
        viewer.menu().map { it.label to it.isOn } shouldBe listOf("Select a field file…" to false)
        choosing(viewer) { viewer.menu().single().run() }
        viewer.fieldLength() shouldBe 20.0
        viewer.current.recording?.fieldPicture?.width shouldBe 40
        val folder = checkNotNull(viewer.current.recording).file.parent
        viewer.settings.state.fields shouldBe mapOf("$folder" to "$file")
        // A selection is for another log of the folder, too, but not for a log of another folder.
        viewer.fields.selectedFor(folder.resolve("b.bag")) shouldBe file
        viewer.fields.selectedFor(tempdir().toPath().resolve("b.bag")).shouldBeNull()
        viewer.menu().map { it.label to it.isOn } shouldBe listOf("Select a field file…" to true, "Deselect the field file" to false)
        choosing(viewer) { viewer.menu().last().run() }
        viewer.fieldLength() shouldBe plain
        viewer.settings.state.fields shouldBe emptyMap()
    }

    test("a selected field has priority over the one beside the logs") {
        val folder = tempdir().toPath()
        val beside = fieldOf(18)
        Files.copy(beside, folder.resolve(FieldFile.NAME))
        Files.copy(beside.resolveSibling("f.png"), folder.resolve("f.png"))
        val viewer = viewerOf(ChosenFiles(fieldOf(20)), log(folder))
        viewer.fieldLength() shouldBe 18.0
        choosing(viewer) { viewer.fields.askForField() }
        viewer.fieldLength() shouldBe 20.0
    }

    test("a file that is not a field is reported and not remembered; a canceled selection is not remembered either") {
        val wrong = Files.writeString(tempdir().toPath().resolve("wrong.json"), "{}")
        val files = ChosenFiles(wrong)
        val viewer = viewerOf(files, log())
        choosing(viewer) { viewer.fields.askForField() }
        viewer.notices.all.single().text shouldEndWith "“top-left” is not a pair of numbers; write it as [x, y]."
        files.file = null
        choosing(viewer) { viewer.fields.askForField() }
        viewer.settings.state.fields shouldBe emptyMap()
        viewer.current.recording?.fieldPicture.shouldBeNull()
    }
})
