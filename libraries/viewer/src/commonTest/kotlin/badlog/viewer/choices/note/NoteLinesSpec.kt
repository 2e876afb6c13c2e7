package badlog.viewer.choices.note

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.int
import io.kotest.property.checkAll
import kotlin.random.Random

class NoteLinesSpec : FunSpec({
    val time = "2026-03-07T14:05:12.345Z"

    test("a change is a line, and only lines that are damaged or of a newer badlog are lost") {
        val hit = NoteChange("1", time, "Ada", Note(93.7, "hit by “254”\n\"hard\""), isRemoved = false)
        hit.toLine() shouldBe """{"id":"1","time":"$time","by":"Ada","do":"write","x":93.7,"text":"hit by “254”\u000a\"hard\""}"""
        val gone = hit.copy(id = "2", isRemoved = true)
        val lines = listOf(hit.toLine(), hit.toLine().dropLast(4), hit.toLine().replace("write", "draw"), "", "[]", gone.toLine())
        noteChangesOf(lines.joinToString("\r\n")).run { changes to unreadable } shouldBe (listOf(hit, gone) to listOf(2, 3, 5))
    }

    fun notesOf(beginning: List<Note>, changes: List<NoteChange>) = NoteHistory.of(beginning, changes).notes

    test("older notes are a beginning: they stay until a line removes them, and come back when one writes them") {
        val old = listOf(Note(1.0, "a"), Note(2.0, "b"))
        val removed = NoteChange("1", time, "Ada", old[0], isRemoved = true)
        val again = NoteChange("2", time.replace("12.345", "12.346"), "Ben", old[0], isRemoved = false)
        notesOf(old, emptyList()) shouldBe old
        notesOf(old, listOf(removed)) shouldBe old.drop(1)
        notesOf(old, listOf(again, removed)) shouldBe old
        val atZero = removed.copy(note = Note(0.0, "a"))
        notesOf(listOf(Note(-0.0, "a")), listOf(atZero)) shouldBe emptyList()
    }

    test("lines of three laptops make the same notes in any order and with repetitions") {
        checkAll(Arb.int(), Arb.int(0..40)) { seed, length ->
            val random = Random(seed)
            val laptops = List(3) { laptop ->
                List(random.nextInt(length + 1)) { i ->
                    val note = Note(random.nextInt(3).toDouble(), "note ${random.nextInt(3)}")
                    val id = if (random.nextInt(8) == 0) "id" else "$laptop-$i"
                    NoteChange(id, "2026-03-07T14:0${random.nextInt(3)}:00.000Z", "P$laptop", note, random.nextBoolean())
                }
            }
            val old = listOf(Note(0.0, "note 1"))
            val one = notesOf(old, laptops.flatten())
            repeat(3) {
                val text = laptops.shuffled(random).joinToString("") { laptop -> laptop.joinToString("") { "${it.toLine()}\n" } }
                val merged = noteChangesOf(text).changes
                notesOf(old, (merged + merged.shuffled(random).take(5)).shuffled(random)) shouldBe one
            }
        }
    }
})
