package badlog.viewer.choices.note

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldNotContain
import io.kotest.property.Arb
import io.kotest.property.arbitrary.arbitrary
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.checkAll

class NoteHistorySpec : FunSpec({
    val start = listOf(Note(1.0, "a"), Note(2.0, "b"), Note(3.0, "c"))
    var clock = 0

    fun time(last: String?): String {
        val thousandths = "${clock++ + 10_000}"
        return maxOf("2026-03-07T14:05:${thousandths.take(2)}.${thousandths.drop(2)}Z", last.orEmpty())
    }

    /** The changes of a tab that shows these notes. */
    fun NoteHistory.changed(step: Notebook.() -> Notebook) = changesTo(Notebook(notes).step().notes, notes, "Ada", ::time) {
        "id-${clock++}"
    }

    fun NoteHistory.after(changes: List<NoteChange>) = NoteHistory.of(unchanged, this.changes + changes)

    beforeTest { clock = 0 }

    class Deed(val tab: Int, val kind: Int, val note: Int)
    val deeds = Arb.list(arbitrary { Deed(Arb.int(0..2).bind(), Arb.int(0..3).bind(), Arb.int(0..5).bind()) }, 0..40)

    test("after any actions of tabs and copies, each note exists once, with its latest text, unless it was removed last") {
        checkAll(deeds) { all ->
            clock = 0
            var stored = emptyList<NoteChange>()
            val given = MutableList(3) { NoteHistory.of(start, emptyList()) }
            val tabs = given.toMutableList()
            // The text of each note that exists, by its place.
            val wanted = HashMap(start.associate { it.x to it.text })
            all.forEachIndexed { i, deed ->
                val tab = tabs[deed.tab]
                val seen = tab.notes.getOrNull(deed.note)
                val made = when {
                    // A copy is opened with the notes that the tab showed.
                    deed.kind == 3 -> emptyList<NoteChange>().also { given[(deed.tab + 1) % 3] = tab }

                    deed.kind == 0 -> tab.changed { begun(10.0 + i).typed("new $i").kept() }.also { wanted[10.0 + i] = "new $i" }

                    seen == null -> emptyList()

                    deed.kind == 1 -> tab.changed { without(seen) }.also { wanted -= seen.x }

                    else -> tab.changed { changing(seen).typed("text $i").kept() }.also { wanted[seen.x] = "text $i" }
                }
                val read = noteChangesOf(stored.toLines()).changes
                stored = NoteHistory.of(emptyList(), read + tab.changes + made).changes
                tabs[deed.tab] = NoteHistory.of(given[deed.tab].unchanged, given[deed.tab].changes + stored)
            }
            for (page in given) {
                NoteHistory.of(page.unchanged, page.changes + stored).notes shouldBe wanted.map { Note(it.key, it.value) }.sortedBy { it.x }
            }
        }
    }

    test("two notes at one moment are two, and a text that both tabs wrote exists once") {
        val before = NoteHistory.of(start, emptyList())
        val one = before.changed { with(notes + Note(9.0, "mine") + Note(9.5, "both")) }
        val other = before.changed { with(notes + Note(9.0, "theirs") + Note(9.5, "both")) }
        val both = before.after(one + other)
        both.notes.drop(3) shouldBe listOf(Note(9.0, "mine"), Note(9.0, "theirs"), Note(9.5, "both"))
        both.after(both.changed { without(Note(9.5, "both")) }).notes.last() shouldBe Note(9.0, "theirs")
        both.after(both.changed { changing(Note(9.0, "mine")).typed("theirs").kept() }).notes.drop(3) shouldBe
            listOf(Note(9.0, "theirs"), Note(9.5, "both"))
    }

    test("a new note with the first text of another one at its moment is another note") {
        val changed = NoteHistory.of(start, emptyList()).let { it.after(it.changed { changing(start[0]).typed("x").kept() }) }
        changed.after(changed.changed { begun(1.0).typed("a").kept() }).notes.take(2) shouldBe listOf(Note(1.0, "x"), Note(1.0, "a"))
    }

    test("a removed note is back when it is written once more") {
        val removed = NoteHistory.of(start, emptyList()).let { it.after(it.changed { without(start[0]) }) }
        removed.notes shouldBe start.drop(1)
        removed.after(removed.changed { begun(1.0).typed("a").kept() }).notes shouldBe start
    }

    test("removed texts are in no line, and a note has the same origin on every platform") {
        val history = NoteHistory.of(listOf(Note(1.0, "secret"), Note(2.0, "wrong")), emptyList())
        val made = history.changed { without(Note(1.0, "secret")).changing(Note(2.0, "wrong")).typed("right").kept() }
        val lines = history.after(made).changes.joinToString("\n") { it.toLine() }
        lines shouldNotContain "secret"
        lines shouldNotContain "wrong"
        history.after(made).changes.map { it.origin } shouldBe listOf("-906277200", "113405357")
    }

    test("an older badlog, which identifies notes by their texts, reads the same notes") {
        val history = NoteHistory.of(start, emptyList())
        val first = history.changed { changing(start[0]).typed("a1").kept() }
        val second = history.after(first).let { it.changed { changing(Note(1.0, "a1")).typed("a2").kept().without(start[1]) } }
        val texts = start.toMutableSet()
        for (change in first + second) if (change.isRemoved) texts -= change.note else texts += change.note
        texts shouldBe setOf(Note(1.0, "a2"), start[2])
    }
})
