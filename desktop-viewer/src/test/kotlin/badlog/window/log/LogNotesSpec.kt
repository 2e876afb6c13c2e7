package badlog.window.log

import androidx.compose.ui.test.ExperimentalTestApi
import androidx.compose.ui.test.onNodeWithContentDescription
import androidx.compose.ui.test.onNodeWithText
import androidx.compose.ui.test.performClick
import androidx.compose.ui.test.performTextInput
import androidx.compose.ui.test.v2.runDesktopComposeUiTest
import badlog.exporter.NotesFile
import badlog.files.UserFolders
import badlog.viewer.choices.note.Note
import badlog.viewer.state.PlaceAction
import badlog.window.TestInspector
import badlog.window.app.Viewer
import badlog.window.sidebar.FrontPart
import badlog.window.sidebar.InspectorTab
import badlog.window.theme.Theme
import badlog.window.theme.ViewerTheme
import badlog.window.waiting.waitFor
import io.kotest.assertions.nondeterministic.eventually
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.Job
import kotlinx.coroutines.launch
import java.nio.file.Files
import kotlin.time.Duration.Companion.seconds

@OptIn(ExperimentalTestApi::class)
class LogNotesSpec : FunSpec({
    val home = tempdir().toPath()
    val log = home.resolve("q42.csv")
    Files.writeString(log, "Time,A\n" + (0..100).joinToString("") { "$it,${it % 7}\n" })

    fun viewer(scope: CoroutineScope) = Viewer(scope, UserFolders(home, home)).apply {
        val open = OpenRecording.read(log)
        current.replace(open)
        view.send(PlaceAction.Open(open.span))
        panels.change { copy(inspector = InspectorTab.NOTES) }
    }

    test("a note is written at the cursor, changed and removed, and stored beside the log each time") {
        runDesktopComposeUiTest(360, 600) {
            val scope = CoroutineScope(Dispatchers.Unconfined + Job())
            val viewer = viewer(scope)
            setContent { ViewerTheme(Theme.LIGHT) { TestInspector(viewer) } }
            scope.launch { viewer.notes.run() }
            waitFor { viewer.notes.state.log == log.toAbsolutePath() }
            viewer.view.send(PlaceAction.Pin(42.0, second = null))
            onNodeWithContentDescription("Write a note at the cursor (M)").performClick()
            onNodeWithContentDescription("Text of the note").performTextInput("hit by 254")
            onNodeWithContentDescription("Save the note (Enter)").performClick()
            waitFor { viewer.notes.draft == null }
            waitFor { NotesFile.read(log).notes == listOf(Note(42.0, "hit by 254")) }
            viewer.panels.change { copy(front = FrontPart.DETAILS) }
            onNodeWithText("hit by 254").performClick()
            runOnIdle { viewer.panels.state.front shouldBe FrontPart.GRAPHS }
            onNodeWithContentDescription("Change the note", substring = true).performClick()
            onNodeWithContentDescription("Text of the note").performTextInput("again ")
            onNodeWithContentDescription("Save the note (Enter)").performClick()
            waitFor { viewer.notes.draft == null }
            waitFor { NotesFile.read(log).notes.single().text.length == "again hit by 254".length }
            onNodeWithContentDescription("Remove the note", substring = true).performClick()
            waitFor { viewer.notes.all.isEmpty() }
            waitFor { NotesFile.read(log).notes.isEmpty() }
            // Lines are never removed from the file.
            Files.readAllLines(NotesFile.of(log)).size shouldBe 4
            runOnIdle { viewer.notices.all.last().action?.run?.invoke() }
            waitFor { viewer.notes.all.size == 1 }
            waitFor { NotesFile.read(log).notes.size == 1 }
            Files.delete(NotesFile.of(log))
            scope.coroutineContext[Job]?.cancel()
        }
    }

    test("a note written before the notes of the log are read replaces none of them") {
        val earlier = listOf(Note(7.0, "from yesterday"))
        NotesFile.update(log, earlier, read = emptyList())
        // Notes are not read here.
        val viewer = viewer(CoroutineScope(Dispatchers.Unconfined))
        viewer.notes.write(1.0)
        viewer.notes.type("too early")
        viewer.notes.keep()
        NotesFile.read(log).notes shouldBe earlier
        viewer.notes.draft?.text shouldBe "too early"
        viewer.notices.all.single().text shouldBe "The notes of this log are still being read; try again in a moment."
        Files.delete(NotesFile.of(log))
    }

    test("damaged notes are reported and not replaced, and new ones are written beside them") {
        Files.writeString(NotesFile.beginningOf(log), "damaged")
        runDesktopComposeUiTest(360, 600) {
            val scope = CoroutineScope(Dispatchers.Unconfined + Job())
            val viewer = viewer(scope)
            setContent { ViewerTheme(Theme.LIGHT) { TestInspector(viewer) } }
            scope.launch { viewer.notes.run() }
            waitFor { viewer.notices.all.any { "q42.csv.notes.json are damaged" in it.text } }
            viewer.notes.write(1.0)
            viewer.notes.type("new")
            viewer.notes.keep()
            viewer.notes.write(2.0)
            viewer.notes.type("newer")
            viewer.notes.keep()
            waitFor { NotesFile.read(log).notes.size == 2 }
            viewer.notes.all shouldBe listOf(Note(1.0, "new"), Note(2.0, "newer"))
            scope.coroutineContext[Job]?.cancel()
        }
        Files.readString(NotesFile.beginningOf(log)) shouldBe "damaged"
        Files.delete(NotesFile.beginningOf(log))
        Files.delete(NotesFile.of(log))
    }

    test("a note that cannot be written is reported, and its text stays") {
        val folder = Files.createDirectory(home.resolve("gone"))
        val scope = CoroutineScope(Dispatchers.Unconfined + Job())
        val viewer = viewer(scope)
        viewer.notes.change { StoredNotes(folder.resolve("q1.csv")) }
        Files.delete(folder)
        viewer.notes.write(1.0)
        viewer.notes.type("brownout")
        viewer.notes.keep()
        eventually(60.seconds) { viewer.notices.all.single().text shouldContain "cannot be written" }
        viewer.notes.draft?.text shouldBe "brownout"
        viewer.notes.all shouldBe emptyList()
        scope.coroutineContext[Job]?.cancel()
    }
})
