package badlog.exporter

import badlog.core.bag.Mutant
import badlog.files.FolderScan
import badlog.protocol.PageAdditions
import badlog.viewer.choices.note.Note
import badlog.viewer.choices.note.NoteChange
import badlog.viewer.choices.note.NoteHistory
import badlog.viewer.choices.note.NotesException
import badlog.viewer.choices.note.notesOfJson
import badlog.viewer.choices.note.toJson
import badlog.viewer.choices.note.toLine
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldStartWith
import io.kotest.property.PropertyTesting
import java.io.RandomAccessFile
import java.nio.file.Files
import kotlin.random.Random

private val MUTANTS = PropertyTesting.defaultIterationCount

class NotesFileSpec : FunSpec({
    val log = tempdir().toPath().resolve("q42.bag")
    val notes = listOf(Note(1.0, "first \"hit\"\n‹second line›"), Note(93.7, "brownout"))

    test("notes are beside their log, are not listed as a log, and a removal is another line") {
        Files.writeString(log, "Time,A\n0,1\n")
        NotesFile.read(log).notes shouldBe emptyList()
        NotesFile.update(log, notes, read = emptyList()).notes shouldBe notes
        FolderScan.of(log.parent).files.map { it.path } shouldBe listOf(log)
        val before = Files.readString(NotesFile.of(log))
        NotesFile.update(log, emptyList(), read = notes).notes shouldBe emptyList()
        Files.readString(NotesFile.of(log)).take(before.length) shouldBe before
        Files.readAllLines(NotesFile.of(log)).size shouldBe 4
        Files.delete(NotesFile.of(log))
    }

    test("the file has the changes of two windows, whichever writes last, and of another laptop") {
        NotesFile.update(log, notes, read = emptyList())
        val first = NotesFile.update(log, listOf(notes[0], Note(5.0, "first window")), read = notes).notes
        first shouldBe listOf(notes[0], Note(5.0, "first window"))
        val second = NotesFile.update(log, notes + Note(99.0, "second window"), read = notes).notes
        second shouldBe listOf(notes[0], Note(5.0, "first window"), Note(99.0, "second window"))
        val other = NoteChange("1", "2026-03-07T14:05:12.345Z", "Ada", Note(50.0, "other laptop"), isRemoved = false)
        val copy = Files.writeString(log.resolveSibling("q42.bag.notes-pit (conflicted copy).jsonl"), other.toLine())
        NotesFile.read(log).notes shouldBe (second + other.note).sortedBy { it.x }
        Files.delete(copy)
        Files.delete(NotesFile.of(log))
    }

    test("the notes of an older badlog come first, and its file stays unchanged") {
        val text = notes.toJson()
        Files.writeString(NotesFile.beginningOf(log), text)
        NotesFile.read(log).notes shouldBe notes
        NotesFile.update(log, notes.drop(1) + Note(99.0, "new"), read = notes).notes shouldBe notes.drop(1) + Note(99.0, "new")
        Files.readString(NotesFile.beginningOf(log)) shouldBe text
        Files.delete(NotesFile.beginningOf(log))
        Files.delete(NotesFile.of(log))
    }

    test("a damaged file is reported, and does not affect the others; unreadable lines are counted") {
        NotesFile.update(log, listOf(Note(5.0, "mine")), read = emptyList())
        Files.writeString(NotesFile.beginningOf(log), "{\"notes\":7}")
        val unreadable = Files.createFile(log.resolveSibling("q42.bag.notes-pit.jsonl"))
        RandomAccessFile(unreadable.toFile(), "rw").use { it.setLength(17L shl 20) }
        val damaged = Files.writeString(log.resolveSibling("q42.bag.notes-x.jsonl"), "<<<<<<< HEAD\n")
        NotesFile.read(log).let { read ->
            read.notes shouldBe listOf(Note(5.0, "mine"))
            read.problems shouldContainExactlyInAnyOrder listOf(
                "The notes in q42.bag.notes.json are damaged: “notes” is not a list. Repair the file, or delete it.",
                "$unreadable cannot be read (it is larger than 16 MB); copy it to this computer's disk first.",
                "Line 1 of q42.bag.notes-x.jsonl is skipped: it is damaged, or from a newer badlog. It stays in the file.",
            )
        }
        Files.write(NotesFile.beginningOf(log), byteArrayOf(-1, -2, 7))
        NotesFile.read(log).problems.first() shouldStartWith "The notes in q42.bag.notes.json are damaged"
        listOf(NotesFile.beginningOf(log), unreadable, damaged, NotesFile.of(log)).forEach(Files::delete)
    }

    test("a laptop with a clock years behind can change a note; the new text is written before the removal of the old one") {
        val ahead = NoteChange("1", "2099-03-07T14:05:12.345Z", "Ada", notes[0], isRemoved = false)
        Files.writeString(log.resolveSibling("q42.bag.notes-pit.jsonl"), ahead.toLine())
        NotesFile.update(log, listOf(Note(1.0, "no hit")), read = notes.take(1)).notes shouldBe listOf(Note(1.0, "no hit"))
        Files.readAllLines(NotesFile.of(log)).map { "\"remove\"" in it } shouldBe listOf(false, true)
        Files.readAllLines(NotesFile.of(log)).map { "2099" in it } shouldBe listOf(true, true)
        Files.delete(log.resolveSibling("q42.bag.notes-pit.jsonl"))
        Files.delete(NotesFile.of(log))
    }

    test("the later of two windows' texts for one note counts, also in a page, which does not have the authors") {
        NotesFile.update(log, notes, read = emptyList())
        NotesFile.update(log, listOf(Note(1.0, "first window"), notes[1]), read = notes)
        NotesFile.update(log, listOf(Note(1.0, "second window"), notes[1]), read = notes).notes shouldBe
            listOf(Note(1.0, "second window"), notes[1])
        val read = NotesFile.read(log)
        val additions = PageAdditions().withNotes(read.history, problem = null)
        NoteHistory.of(additions.notes, additions.noteChanges).notes shouldBe read.notes
        additions.noteChanges.map { it.author }.toSet() shouldBe setOf("")
        Files.delete(NotesFile.of(log))
    }

    test("a damaged file has either notes at finite x, or a sentence") {
        val whole = notes.toJson()
        val random = Random(12)
        repeat(MUTANTS) {
            val mutant = Mutant.of(whole.encodeToByteArray(), random, whole.length)
            try {
                for (note in notesOfJson(mutant.bytes.decodeToString())) note.x.isFinite() shouldBe true
            } catch (e: NotesException) {
                e.message.isNullOrBlank() shouldBe false
            }
        }
    }
})
