package badlog.viewer.choices.note

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.map
import io.kotest.property.arbitrary.pair
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll

class NotesJsonSpec : FunSpec({
    test("notes are read back as written, in the order of x") {
        val notes = Arb.list(Arb.pair(Arb.double(), Arb.string(1..50)), 0..20)
            // JavaScript writes -0 as 0.
            .map { all -> all.filter { it.first.isFinite() && it.second.isNotBlank() }.map { Note(it.first + 0.0, it.second) } }
        checkAll(100, notes) { notesOfJson(it.toJson()) shouldBe it.sortedBy { note -> note.x } }
    }

    test("additions of a newer badlog are ignored, and its changes refused") {
        notesOfJson("""{"notes":[{"x":1.5,"text":"hit","color":"red"}],"author":"A"}""") shouldBe listOf(Note(1.5, "hit"))
        shouldThrow<NotesException> { notesOfJson("""{"version":2,"notes":[]}""") }.message shouldBe
            "The notes were saved by a newer badlog; update badlog."
    }

    test("a text without notes is refused with the mistake") {
        for ((text, message) in listOf(
            "" to "This is not a JSON object.",
            "{}" to "“notes” is not a list.",
            """{"notes":[{"x":"1","text":"a"}]}""" to "“x” of note 1 is not a number.",
            """{"notes":[{"x":1e999,"text":"a"}]}""" to "“x” of note 1 is not a number.",
            """{"notes":[{"x":1,"text":"a"},{"x":1,"text":" "}]}""" to "“text” of note 2 is missing.",
            """{"notes":[7]}""" to "“x” of note 1 is not a number.",
            """{"notes":[{"x":1,"text":"${"a".repeat(2001)}"}]}""" to "“text” of note 1 has 2001 characters; at most 2000 are allowed.",
            """{"notes":[${List(1001) { """{"x":1,"text":"a"}""" }.joinToString(",")}]}""" to "There are 1001 notes; a log has at most 1000.",
        )) {
            shouldThrow<NotesException> { notesOfJson(text) }.message shouldBe message
        }
    }
})
