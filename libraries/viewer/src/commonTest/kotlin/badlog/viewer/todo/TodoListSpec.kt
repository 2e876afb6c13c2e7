package badlog.viewer.todo

import badlog.core.recording.Severity
import badlog.signals.match.MatchOfLog
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.RandomSource
import io.kotest.property.arbitrary.arbitrary
import io.kotest.property.arbitrary.int
import io.kotest.property.checkAll
import kotlin.random.Random

class TodoListSpec : FunSpec({
    val brownout = FaultTask("Browned out", "PDP/Voltage")
    val error = FoundFault(brownout, Severity.ERROR, "The battery fell to 6.1 V.")
    val slow = FoundFault(FaultTask("Slow loops", null), Severity.WARNING, "Loops took 31 ms.")

    fun log(number: Int, vararg faults: FoundFault, second: Long = 1_000_000L + number * 600) = FoundLog("q$number.bag", MatchOfLog("Mill Creek", "Qualification", "$number"), second, faults.toList())

    var count = 0
    fun change(task: TodoSubject, deed: TodoDeed, seen: Long? = null, by: String = "Ada"): TodoChange {
        count++
        return TodoChange("id$count", "2026-03-07T14:${(10 + count / 60)}:${10 + count % 50}.000Z", by, task, deed, seen)
    }
    beforeTest { count = 0 }

    test("an error of one of the last four matches is on the list without anybody putting it there, a warning is not") {
        val logs = listOf(log(1, error), log(2, slow), log(3), log(4))
        TodoList.of(emptyList(), logs).open.map { it.title } shouldBe listOf("Browned out")
        TodoList.of(emptyList(), logs + log(5)).open.shouldBeEmpty()
        TodoList.of(listOf(change(slow.task, TodoDeed.Assign("Ben"))), logs).open.map { it.title to it.person } shouldBe
            listOf("Browned out" to "", "Slow loops" to "Ben")
    }

    test("what was done comes back when it is found in a log recorded later, and says since when") {
        val done = change(brownout, TodoDeed.Done("replaced main breaker", "Qualification 58"), seen = log(55).second)
        val before = TodoList.of(listOf(done), listOf(log(55, error)))
        before.open.shouldBeEmpty()
        before.done.single().done?.text shouldBe "Done before Qualification 58 by Ada: replaced main breaker"
        // The log of a match before it arrives late.
        TodoList.of(listOf(done), listOf(log(55, error), log(57, error))).open.shouldBeEmpty()
        val again = TodoList.of(listOf(done), listOf(log(55, error), log(58, error))).open.single()
        again.againText shouldBe "Again, after it was done before Qualification 58."
        again.lines shouldBe listOf(
            "Again, after it was done before Qualification 58.",
            "Done before Qualification 58 by Ada: replaced main breaker",
            "The battery fell to 6.1 V.",
            "Found in Qualification 58, and 1 log before.",
        )
        // The other match of the same number is at another event.
        TodoList.of(listOf(done), listOf(log(12, error, second = log(55).second + 86_400 * 20))).open.single().isAgain shouldBe true
        val twice = change(brownout, TodoDeed.Done("new battery lead"), seen = log(58).second)
        TodoList.of(listOf(twice, done), listOf(log(55, error), log(58, error))).open.shouldBeEmpty()
        TodoList.of(listOf(twice, done), listOf(log(58, error), log(60, error))).open.single().againText shouldBe
            "Again, after it was done by Ada."
    }

    test("what was done before the match after another has not failed in that one") {
        val done = change(brownout, TodoDeed.Done(before = "the match after Qualification 58"), seen = log(58).second)
        TodoList.of(listOf(done), listOf(log(58, error, second = log(58).second + 5))).open.shouldBeEmpty()
        TodoList.of(listOf(done), listOf(log(61, error))).open.single().isAgain shouldBe true
    }

    test("own items and notes are opened, assigned, done, removed and opened again") {
        val own = OwnTask("Check the radio")
        val note = NoteTask("q58.bag", 93.7, "It smells.")
        val changes = ArrayList<TodoChange>()
        fun open() = TodoList.of(changes, emptyList()).open.map { it.title to it.person }
        changes += change(own, TodoDeed.Open)
        changes += change(note, TodoDeed.Assign("Cem"))
        open() shouldBe listOf("Check the radio" to "", "It smells." to "Cem")
        changes += change(note, TodoDeed.Done())
        changes += change(own, TodoDeed.Remove)
        open().shouldBeEmpty()
        TodoList.of(changes, emptyList()).item(own) shouldBe null
        changes += change(note, TodoDeed.Open)
        changes += change(own, TodoDeed.Assign("Ada"))
        open() shouldBe listOf("Check the radio" to "Ada", "It smells." to "Cem")
    }

    test("a fault that was removed stays away until somebody puts it back") {
        val removed = change(brownout, TodoDeed.Remove, seen = log(50).second)
        TodoList.of(listOf(removed), listOf(log(60, error))).open.shouldBeEmpty()
        TodoList.of(listOf(removed, change(brownout, TodoDeed.Open)), listOf(log(60, error))).open.single().task shouldBe brownout
    }

    test("a checklist begins with nothing ticked before each match") {
        val lines = listOf("Battery in", "Bumpers tight")
        val said = change(NextMatch("Qualification 61"), TodoDeed.Open, seen = log(58).second)
        val ticked = change(Check("Battery in", "Qualification 61"), TodoDeed.Done())
        fun ticks(logs: List<FoundLog>) = TodoList.of(listOf(said, ticked), logs).run { next to checklist(lines).map { it.done?.by } }
        ticks(listOf(log(58))) shouldBe ("Qualification 61" to listOf("Ada", null))
        ticks(listOf(log(58), log(61))) shouldBe ("the match after Qualification 61" to listOf(null, null))
        TodoList.of(listOf(said, ticked, change(ticked.subject, TodoDeed.Open)), listOf(log(58))).checklist(lines)[0].done shouldBe null
        TodoList.of(emptyList(), emptyList()).next shouldBe "the next match"
    }

    test("what people type as a match is named as logs name it") {
        listOf("q58", " Q58 ", "Qualification 58", "the final", "").map(::matchText) shouldBe
            listOf("Qualification 58", "Qualification 58", "Qualification 58", "the final", "")
    }

    test("200 random histories on three laptops, merged in any order and with lines twice, give the same list") {
        val subjects = listOf(brownout, slow.task, OwnTask("Radio"), NoteTask("q1.bag", 2.5, "Odd"), Check("Battery", "Qualification 3"))
        val histories = arbitrary { source: RandomSource -> source.random.nextInt() }
        checkAll(200, histories, Arb.int(0..40)) { seed, length ->
            val random = Random(seed)
            // Clocks of laptops differ, and so times are neither in order nor unique.
            val laptops = List(3) { laptop ->
                List(random.nextInt(length + 1)) { i ->
                    val deed = when (random.nextInt(4)) {
                        0 -> TodoDeed.Open
                        1 -> TodoDeed.Remove
                        2 -> TodoDeed.Assign(listOf("", "Ada", "Ben")[random.nextInt(3)])
                        else -> TodoDeed.Done("deed $i", "Qualification ${random.nextInt(5)}")
                    }
                    val subject = if (random.nextInt(6) == 0) NextMatch("Qualification ${random.nextInt(5)}") else subjects.random(random)
                    // The same id twice is what a damaged file, or a copied one, may hold.
                    val id = if (random.nextInt(8) == 0) "id" else "$laptop-$i"
                    val time = "2026-03-07T14:0${random.nextInt(3)}:00.000Z"
                    TodoChange(id, time, "P$laptop", subject, deed, seen = random.nextLong(1_000_000, 1_003_000))
                }
            }
            val logs = List(4) { log(it, *listOf(error, slow).filter { random.nextBoolean() }.toTypedArray()) }
            fun shown(changes: List<TodoChange>, logs: List<FoundLog>) = TodoList.of(changes, logs).run {
                listOf(open, done, next, checklist(listOf("Battery"))).toString()
            }
            val one = shown(laptops.flatten(), logs)
            repeat(3) {
                val text = laptops.shuffled(random).joinToString("") { laptop -> laptop.joinToString("") { "${it.toLine()}\n" } }
                val merged = TodoLines.of(text).changes
                shown((merged + merged.shuffled(random).take(5)).shuffled(random), (logs + logs.take(1)).shuffled(random)) shouldBe one
            }
        }
    }
})
