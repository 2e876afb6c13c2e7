package badlog.window.log

import badlog.exporter.NotesFile
import badlog.files.UserFolders
import badlog.viewer.choices.note.Note
import badlog.viewer.state.PlaceAction
import badlog.window.app.Viewer
import badlog.window.waiting.awaitState
import badlog.window.waiting.onWindowThread
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

class LogNotesSpec : FunSpec({
    val home = tempdir().toPath()
    val log = home.resolve("q42.csv")
    Files.writeString(log, "Time,A\n" + (0..100).joinToString("") { "$it,${it % 7}\n" })

    val open = OpenRecording.read(log)

    fun viewer(scope: CoroutineScope) = Viewer(scope, UserFolders(home, home)).apply {
        current.replace(open)
        view.send(PlaceAction.Open(open.span))
    }

    test("a note is written at the cursor, changed and removed, and stored beside the log each time") {
        onWindowThread {
            val viewer = viewer(this)
            val following = launch { viewer.notes.run() }
            awaitState { viewer.notes.state.log == log.toAbsolutePath() }

            suspend fun keeps(vararg notes: Note) = awaitState { NotesFile.read(log).notes == notes.toList() }
            viewer.notes.write(42.0)
            viewer.notes.type("hit by 254")
            viewer.notes.keep()
            keeps(Note(42.0, "hit by 254"))
            viewer.notes.rewrite(viewer.notes.all.single())
            viewer.notes.type("hit by 254 again")
            viewer.notes.keep()
            keeps(Note(42.0, "hit by 254 again"))
            viewer.notes.remove(viewer.notes.all.single(), "42 s")
            keeps()
            // Lines are never removed from the file.
            Files.readAllLines(NotesFile.of(log)).size shouldBe 4
            viewer.notices.all.last().action?.run?.invoke()
            keeps(Note(42.0, "hit by 254 again"))
            Files.delete(NotesFile.of(log))
            following.cancel()
        }
    }

    test("a note written before the notes of the log are read does not replace any of them") {
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
        onWindowThread {
            val viewer = viewer(this)
            val following = launch { viewer.notes.run() }
            awaitState { viewer.notices.all.any { "q42.csv.notes.json are damaged" in it.text } }
            for ((x, text) in listOf(1.0 to "new", 2.0 to "newer")) {
                viewer.notes.write(x)
                viewer.notes.type(text)
                viewer.notes.keep()
            }
            awaitState { NotesFile.read(log).notes.size == 2 }
            viewer.notes.all shouldBe listOf(Note(1.0, "new"), Note(2.0, "newer"))
            following.cancel()
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
