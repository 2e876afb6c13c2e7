package badlog.viewer.choices.note

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.arbitrary
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll

/** What several tabs or windows do with the notes of one log. */
class MergedNotesSpec : FunSpec({
    class Deed(val tab: Int, val kind: Int, val note: Int)
    val deeds = Arb.list(arbitrary { Deed(Arb.int(0..2).bind(), Arb.int(0..2).bind(), Arb.int(0..5).bind()) }, 0..40)
    val start = listOf(Note(1.0, "a"), Note(2.0, "b"), Note(3.0, "c"))

    test("whatever tabs write in turn, each note stays, and of two texts of one note the later one counts") {
        checkAll(300, deeds) { all ->
            var stored = start
            val known = MutableList(3) { start }
            // The text of each note that exists, by its place.
            val wanted = HashMap(start.associate { it.x to it.text })
            all.forEachIndexed { i, deed ->
                val now = Notebook(known[deed.tab])
                val seen = now.notes.getOrNull(deed.note)
                val changed = when {
                    deed.kind == 0 -> now.begun(10.0 + i).typed("new $i").kept().also { wanted[10.0 + i] = "new $i" }

                    // What another tab has removed, this one does not change: that would bring it back.
                    seen == null || seen.x !in wanted -> return@forEachIndexed

                    deed.kind == 1 -> now.without(seen).also { wanted -= seen.x }

                    else -> now.changing(seen).typed("text $i").kept().also { wanted[seen.x] = "text $i" }
                }
                stored = notesOfJson(changed.notes.notesMergedWith(stored, known[deed.tab]).toJson())
                known[deed.tab] = stored
            }
            stored.map { it.x to it.text }.toSet() shouldBe wanted.toList().toSet()
        }
    }

    test("two notes at one moment are both kept, and a text that both wrote is there once") {
        val mine = start + Note(9.0, "mine") + Note(9.5, "both")
        val theirs = start + Note(9.0, "theirs") + Note(9.5, "both")
        mine.notesMergedWith(theirs, start).drop(3) shouldBe listOf(Note(9.0, "mine"), Note(9.0, "theirs"), Note(9.5, "both"))
    }

    test("a note that this tab changed and another removed stays as it is written later") {
        val changed = listOf(Note(1.0, "again"), Note(2.0, "b"), Note(3.0, "c"))
        changed.notesMergedWith(start.drop(1), start) shouldBe changed
        start.drop(1).notesMergedWith(changed, start) shouldBe start.drop(1)
    }
})
