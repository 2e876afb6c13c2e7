package badlog.viewer.todo

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldNotContain
import io.kotest.property.Arb
import io.kotest.property.arbitrary.arbitrary
import io.kotest.property.arbitrary.double
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.long
import io.kotest.property.arbitrary.map
import io.kotest.property.arbitrary.orNull
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll

class TodoLinesSpec : FunSpec({
    val texts = Arb.string(1..30).map { it.ifBlank { "a\n“b”\u2028" } }
    val numbers = Arb.double().map { if (it.isFinite()) it + 0.0 else 1.5 }
    val changes = arbitrary {
        val subject = when (Arb.int(0..4).bind()) {
            0 -> FaultTask(texts.bind(), texts.orNull().bind())
            1 -> NoteTask(texts.bind(), numbers.bind(), texts.bind())
            2 -> OwnTask(texts.bind())
            3 -> Check(texts.bind(), texts.bind())
            else -> NextMatch(texts.bind())
        }
        val deeds = listOf(TodoDeed.Open, TodoDeed.Remove, TodoDeed.Assign(Arb.string(0..5).bind()), TodoDeed.Done(texts.bind(), texts.orNull().bind()))
        TodoChange(texts.bind(), "2026-03-07T14:05:12.345Z", texts.bind(), subject, Arb.element(deeds).bind(), Arb.long().orNull().bind(), texts.orNull().bind())
    }

    test("a change is one line, and is read back as written") {
        checkAll(changes) { change ->
            val line = change.toLine()
            line shouldNotContain "\n"
            val read = todoChangesOf("$line\n")
            read.unreadable.shouldBeEmpty()
            read.changes shouldBe listOf(change)
        }
    }

    test("a line is as docs/todo.md says") {
        val done = TodoDeed.Done("replaced main breaker", "Qualification 58")
        TodoChange("4f1c", "2026-03-07T14:05:12.345Z", "Ada", FaultTask("Browned out", "PDP/Voltage"), done, 1772891712, "Mill Creek").toLine() shouldBe
            """{"id":"4f1c","time":"2026-03-07T14:05:12.345Z","by":"Ada","do":"done","what":"replaced main breaker",""" +
            """"before":"Qualification 58","rule":"Browned out","topic":"PDP/Voltage","event":"Mill Creek","seen":1772891712}"""
    }

    test("damaged or newer lines are counted, the others are read, and unknown keys are ignored") {
        val good = TodoChange("1", "2026-03-07T14:05:12.345Z", "Ada", OwnTask("Radio"), TodoDeed.Open).toLine()
        val lines = listOf(
            good,
            "",
            good.dropLast(3),
            good.replace("\"open\"", "\"postpone\""),
            good.replace("\"task\"", "\"photo\""),
            good.replace("T14", " 14"),
            good.replace("\"Ada\"", "\"\""),
            "[]",
            good.replace("}", ",\"color\":\"red\"}").replace("\"1\"", "\"2\""),
        )
        val read = todoChangesOf(lines.joinToString("\r\n"))
        read.changes.map { it.id } shouldBe listOf("1", "2")
        read.unreadable shouldBe listOf(3, 4, 5, 6, 7, 8)
    }

    test("a last line without an end may still arrive, and is not reported, but a complete one counts") {
        val good = TodoChange("1", "2026-03-07T14:05:12.345Z", "Ada", OwnTask("Radio"), TodoDeed.Open).toLine()
        todoChangesOf("$good\n${good.dropLast(3)}").let { it.changes.size to it.unreadable } shouldBe (1 to emptyList())
        todoChangesOf("${good.dropLast(3)}\n$good").let { it.changes.size to it.problemOf("a.jsonl") } shouldBe
            (1 to "Line 1 of a.jsonl is skipped: it is damaged, or from a newer badlog. It stays in the file.")
    }

    test("after any cut, change or insertion, every other line is still read") {
        val lines = List(6) { TodoChange("$it", "2026-03-07T14:05:12.345Z", "Ada", OwnTask("Task $it"), TodoDeed.Done("x", "Playoff 1")).toLine() }
        checkAll(Arb.int(0..5), Arb.int(0..300), Arb.string(0..20)) { damaged, at, junk ->
            val text = lines.mapIndexed { i, line ->
                if (i == damaged) line.take(at % line.length) + junk.replace("\n", " ") else line
            }.joinToString("") { "$it\n" }
            val read = todoChangesOf(text)
            read.changes.map { it.id }.filter { it != "$damaged" } shouldBe lines.indices.filter { it != damaged }.map { "$it" }
            read.changes.size + read.unreadable.size shouldBe lines.size - if (text.split('\n')[damaged].isBlank()) 1 else 0
        }
    }
})
