package badlog.viewer.choices.note

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class MarkSpec : FunSpec({
    test("marks are numbered consecutively, with any other notes and in any order") {
        val notes = Notebook().with(listOf(Note(1.0, "hit by 254"))).marked(9.0).marked(4.0)
        notes.notes shouldBe listOf(Note(1.0, "hit by 254"), Note(4.0, "Mark 2"), Note(9.0, "Mark 1"))
        notes.without(Note(9.0, "Mark 1")).marked(5.0).notes.map { it.text } shouldBe listOf("hit by 254", "Mark 2", "Mark 3")
    }

    test("a text that only begins like a mark does not count, nor does a number that is too long") {
        Notebook().with(listOf(Note(1.0, "Mark 8 is here"), Note(2.0, "Mark 99999999999"))).marked(3.0).notes.last().text shouldBe "Mark 1"
    }

    test("the draft of a note stays when a mark is added") {
        Notebook().begun(2.0).typed("the arm").marked(3.0).draft?.text shouldBe "the arm"
    }
})
