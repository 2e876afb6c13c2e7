package badlog.viewer.todo

import badlog.core.recording.Severity
import badlog.signals.match.MatchOfLog
import badlog.viewer.catalog.DateSource
import badlog.viewer.catalog.LogDate
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

    fun log(number: Int, vararg faults: FoundFault, second: Long = 1_000_000L + number * 600) = TodoLog("q$number.bag", MatchOfLog("Mill Creek", "Qualification", "$number"), second, faults.toList())

    var count = 0
    fun change(task: TodoSubject, deed: TodoDeed, seen: Long? = null, by: String = "Ada"): TodoChange {
        count++
        return TodoChange("id$count", "2026-03-07T14:${(10 + count / 60)}:${10 + count % 50}.000Z", by, task, deed, seen)
    }
    beforeTest { count = 0 }

    test("an error of one of the last four matches is on the list by itself, and a warning is not") {
        val logs = listOf(log(1, error), log(2, slow), log(3), log(4))
        TodoList.of(emptyList(), logs).open.map { it.title } shouldBe listOf("Browned out")
        TodoList.of(emptyList(), logs + log(5)).open.shouldBeEmpty()
        TodoList.of(listOf(change(slow.task, TodoDeed.Assign("Ben"))), logs).open.map { it.title to it.person } shouldBe
            listOf("Browned out" to "", "Slow loops" to "Ben")
    }

    test("a repaired fault comes back when it is found in a later log, and says since when") {
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

    test("a repair after Qualification 58 has not failed in that match, but may fail in a later one") {
        change(brownout, TodoDeed.Done("x", "the match after Qualification 58")).mark()?.text shouldBe "Done after Qualification 58 by Ada: x"
        val done = change(brownout, TodoDeed.Done(before = "the match after Qualification 58"), seen = log(58).second)
        TodoList.of(listOf(done), listOf(log(58, error, second = log(58).second + 5))).open.shouldBeEmpty()
        TodoList.of(listOf(done), listOf(log(61, error))).open.single().isAgain shouldBe true
    }

    test("a fault is one item in the logs of robot and Driver Station, and older changes with a topic count") {
        val whole = FaultTask("Browned out", null)
        val done = change(brownout, TodoDeed.Done("replaced main breaker"), seen = log(55).second)
        val logs = listOf(log(58, error.copy(task = whole)), log(58, error.copy(task = whole), second = log(58).second + 2).copy(name = "q58.dslog"))
        val item = TodoList.of(listOf(done), logs).run { (open + this.done).single() }
        item.isAgain shouldBe true
        item.done?.what shouldBe "replaced main breaker"
        TodoList.of(listOf(done, change(whole, TodoDeed.Assign("Ben"))), emptyList()).run { open + this.done }.size shouldBe 1
        // A rule that looks at each motor has an item for each.
        val left = FoundFault(FaultTask("A motor is hot", "Left"), Severity.ERROR, "Left was 90 °C.")
        val right = FoundFault(FaultTask("A motor is hot", "Right"), Severity.ERROR, "Right was 90 °C.")
        TodoList.of(listOf(change(left.task, TodoDeed.Done(), seen = log(59).second)), listOf(log(58, left, right))).open.single().task shouldBe right.task
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

    test("a removed fault stays away until a person opens it again") {
        val removed = change(brownout, TodoDeed.Remove, seen = log(50).second)
        TodoList.of(listOf(removed), listOf(log(60, error))).open.shouldBeEmpty()
        TodoList.of(listOf(removed, change(brownout, TodoDeed.Open)), listOf(log(60, error))).open.single().task shouldBe brownout
    }

    test("a checklist begins without ticks before each match") {
        val lines = listOf("Battery in", "Bumpers tight")
        val said = change(NextMatch("Qualification 61"), TodoDeed.Open, seen = log(58).second)
        val ticked = change(Check("Battery in", "Qualification 61"), TodoDeed.Done())
        fun ticks(logs: List<TodoLog>) = TodoList.of(listOf(said, ticked), logs).run { next to checklist(lines).map { it.done?.by } }
        ticks(listOf(log(58))) shouldBe ("Qualification 61" to listOf("Ada", null))
        ticks(listOf(log(58), log(61))) shouldBe ("the match after Qualification 61" to listOf(null, null))
        TodoList.of(listOf(said, ticked, change(ticked.subject, TodoDeed.Open)), listOf(log(58))).checklist(lines)[0].done shouldBe null
        TodoList.of(emptyList(), emptyList()).next shouldBe "the next match"
    }

    test("numbers of one event are compared without a clock, also in logs without a type") {
        fun done(before: String, seen: Long?, event: String?) = change(brownout, TodoDeed.Done(before = before), seen).copy(event = event)
        fun isAgain(done: TodoChange, log: TodoLog) = TodoList.of(listOf(done), listOf(log)).open.isNotEmpty()
        // The robot's clock was in 2031 when the item was done.
        val wrong = done("Qualification 58", 1_900_000_000, "Mill Creek")
        listOf(57, 58).map { isAgain(wrong, log(it, error)) } shouldBe listOf(false, true)
        val ofOther = log(59, error).copy(match = MatchOfLog("Elm City", "Qualification", "59"))
        isAgain(wrong, ofOther) shouldBe false
        isAgain(done("Match 58", log(55).second, null), log(58, error).copy(match = MatchOfLog(number = "58"))) shouldBe true
    }

    test("a log dated only by its file’s time, or by a clock in the future, is compared by its number alone") {
        val now = log(58).second + 2_000_000_000
        fun date(second: Long, source: DateSource) = TodoLog.of("a", MatchOfLog(), LogDate(second, source), now).isDated
        date(now + 3600, DateSource.VALUES) shouldBe true
        date(now + 2 * 86_400, DateSource.VALUES) shouldBe false
        date(now - 3600, DateSource.FILE_TIME) shouldBe false
        // A laptop in 1970 cannot recognize a date in the future.
        TodoLog.of("a", MatchOfLog(), LogDate(now, DateSource.VALUES), 5).isDated shouldBe true
        val done = change(brownout, TodoDeed.Done(before = "Qualification 58"), seen = 5)
        fun undated(number: Int) = log(number, error, second = 1_900_000_000).copy(isDated = false)
        listOf(57, 58).map { TodoList.of(listOf(done), listOf(undated(it))).open.size } shouldBe listOf(0, 1)
        val practice = undated(1).copy(match = MatchOfLog())
        TodoList.of(listOf(done), listOf(practice)).open.shouldBeEmpty()
        TodoList.of(emptyList(), listOf(log(58), log(12).copy(second = 1_900_000_000, isDated = false))).next shouldBe "the match after Qualification 58"
        TodoList.of(emptyList(), listOf(undated(9), undated(12))).next shouldBe "the match after Qualification 12"
        val said = change(NextMatch("Qualification 61"), TodoDeed.Open, seen = log(58).second)
        TodoList.of(listOf(said), listOf(log(58), undated(70))).next shouldBe "Qualification 61"
    }

    test("the logs of one run are recent together, from the first one on") {
        val early = log(1, error).copy(name = "q1.dslog", second = log(1).second - 300)
        val robot = log(1)
        TodoList.of(emptyList(), listOf(early, robot, log(2), log(3), log(4))).open.size shouldBe 1
        // The same numbers at the next event are other matches.
        val other = listOf(2, 3, 4).map { log(it, second = log(it).second + 20 * 86_400) }
        TodoList.of(emptyList(), listOf(robot, log(2), log(3), log(4, error)) + other).open.size shouldBe 1
        TodoList.of(emptyList(), listOf(robot, log(2), log(3, error), log(4)) + other).open.size shouldBe 0
    }

    test("a tick is for the next match, even if that is named later, and not for another event or day") {
        val lines = listOf("Battery in")
        val unnamed = change(Check("Battery in", "the match after Qualification 58"), TodoDeed.Done(), seen = log(58).second)
        fun isTicked(changes: List<TodoChange>, vararg logs: TodoLog) = TodoList.of(changes, logs.toList()).checklist(lines).single().done != null
        fun said(number: Int) = change(NextMatch("Qualification $number"), TodoDeed.Open, seen = log(58).second)
        isTicked(listOf(unnamed), log(58)) shouldBe true
        val named = said(61)
        isTicked(listOf(unnamed, named), log(58)) shouldBe true
        isTicked(listOf(unnamed, named, change(Check("Battery in", "Qualification 61"), TodoDeed.Open)), log(58)) shouldBe false
        // This is the next match after that, although no log came between.
        isTicked(listOf(unnamed, named, said(65)), log(58)) shouldBe false
        isTicked(listOf(unnamed, said(65)), log(58), log(60)) shouldBe false
        val ticked = change(Check("Battery in", "Qualification 12"), TodoDeed.Done(), seen = log(10).second).copy(event = "Mill Creek")
        val again = change(NextMatch("Qualification 12"), TodoDeed.Open, seen = log(10).second + 20 * 86_400)
        isTicked(listOf(ticked, again), log(10)) shouldBe true
        isTicked(listOf(ticked, again), log(10).copy(match = MatchOfLog("Elm City", "Qualification", "10"))) shouldBe false
        isTicked(listOf(ticked, again), log(10, second = log(10).second + 20 * 86_400)) shouldBe false
        val practice = change(Check("Battery in", UNNAMED_MATCH), TodoDeed.Done(), seen = 5000)
        fun practiced(second: Long) = TodoLog("a", MatchOfLog(), second, emptyList())
        isTicked(listOf(practice), practiced(5000)) shouldBe true
        isTicked(listOf(practice), practiced(5000), practiced(5600)) shouldBe false
    }

    test("a typed match is named as logs name it, and a number has the type of the last match") {
        listOf("q58", " Q58 ", "qual 58", "Q 58", "qualification 58", "Qualification 58", "58", "qm-058").map { matchText(it) }.toSet() shouldBe
            setOf("Qualification 58")
        listOf("sf2m1", "sf 2-1", "the final", "", "after lunch 3").map { matchText(it) } shouldBe
            listOf("Semifinal 2-1", "Semifinal 2-1", "the final", "", "after lunch 3")
        matchText("3", MatchOfLog("Mill Creek", "Elimination", "2")) shouldBe "Elimination 3"
        matchText("3", MatchOfLog(number = "2")) shouldBe "Match 3"
    }

    test("200 random histories on three laptops make the same list, merged in any order and with repetitions") {
        val subjects = listOf(brownout, slow.task, OwnTask("Radio"), NoteTask("q1.bag", 2.5, "Odd"), Check("Battery", "Qualification 3"))
        val histories = arbitrary { source: RandomSource -> source.random.nextInt() }
        checkAll(histories, Arb.int(0..40)) { seed, length ->
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
                    // A damaged file, or a copied one, may have the same id twice.
                    val id = if (random.nextInt(8) == 0) "id" else "$laptop-$i"
                    val time = "2026-03-07T14:0${random.nextInt(3)}:00.000Z"
                    TodoChange(id, time, "P$laptop", subject, deed, seen = random.nextLong(1_000_000, 1_003_000))
                }
            }
            val logs = List(4) { log(it, *listOf(error, slow).filter { random.nextBoolean() }.toTypedArray()) }
            fun shown(changes: List<TodoChange>, logs: List<TodoLog>) = TodoList.of(changes, logs).run {
                listOf(open, done, next, checklist(listOf("Battery"))).toString()
            }
            val one = shown(laptops.flatten(), logs)
            repeat(3) {
                val text = laptops.shuffled(random).joinToString("") { laptop -> laptop.joinToString("") { "${it.toLine()}\n" } }
                val merged = todoChangesOf(text).changes
                shown((merged + merged.shuffled(random).take(5)).shuffled(random), (logs + logs.take(1)).shuffled(random)) shouldBe one
            }
        }
    }
})
