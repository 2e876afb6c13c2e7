package badlog.viewer.choices.note

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class NotebookSpec : FunSpec({
    val hit = Note(3.0, "hit")
    val jam = Note(7.0, "jammed")

    test("a note is written at its moment, among the others in the order of x") {
        val written = Notebook(listOf(hit, jam)).begun(5.0).typed("  slow\n").kept()
        written shouldBe Notebook(listOf(hit, Note(5.0, "slow"), jam))
    }

    test("a changed note replaces the previous one, and stays at its moment") {
        Notebook(listOf(hit, jam)).changing(hit).typed("hit by 254").kept().notes shouldBe listOf(Note(3.0, "hit by 254"), jam)
    }

    test("neither a note without text nor a cancelled one is kept, and a changed one then stays the same") {
        Notebook(listOf(hit)).begun(1.0).typed(" \n").kept() shouldBe Notebook(listOf(hit))
        Notebook(listOf(hit)).begun(1.0).typed("a").cancelled() shouldBe Notebook(listOf(hit))
        Notebook(listOf(hit)).changing(hit).typed("").kept() shouldBe Notebook(listOf(hit))
    }

    test("a text is cut off at the maximum length of a note") {
        Notebook().begun(1.0).typed("a".repeat(Note.MAX_TEXT + 1)).kept().notes.single().text.length shouldBe Note.MAX_TEXT
    }

    test("a removed note disappears, and the draft stays when others change the notes") {
        Notebook(listOf(hit, jam)).without(hit).notes shouldBe listOf(jam)
        Notebook(listOf(hit)).begun(1.0).typed("a").with(listOf(jam, hit)).kept().notes shouldBe listOf(Note(1.0, "a"), hit, jam)
    }

    test("a removal can be undone once, also after other notes were written") {
        Notebook(listOf(hit, jam)).without(hit).begun(5.0).typed("slow").kept().restored(hit).notes shouldBe listOf(hit, Note(5.0, "slow"), jam)
        Notebook(listOf(hit, jam)).restored(hit).notes shouldBe listOf(hit, jam)
    }

    test("a log with the maximum number of notes accepts no more") {
        val all = List(Note.MAX_NOTES) { Note(it.toDouble(), "a") }
        Notebook(all).fullness shouldBe "This log has 1000 notes; remove one first."
        Notebook(all.drop(1)).fullness shouldBe null
    }
})
