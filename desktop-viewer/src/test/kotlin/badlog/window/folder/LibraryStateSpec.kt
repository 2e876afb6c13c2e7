package badlog.window.folder

import badlog.catalog.Content
import badlog.catalog.folder.LogEntry
import badlog.catalog.folder.entry
import badlog.signals.match.MatchOfLog
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.arbitrary
import io.kotest.property.arbitrary.enum
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.orNull
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll

class LibraryStateSpec : FunSpec({
    fun names(state: LibraryState) = state.visible.map { it.fileName }

    val match9 = entry("a.bag", MatchOfLog("Mill Creek Regional", "Qualification", "9", "Red"), 300)
    val match10 = entry("b.bag", MatchOfLog("Mill Creek Regional", "Qualification", "10", "Blue"), 200)
    val bench = entry("day2/bench.csv", second = 100)
    val reboot = entry("reboot.bag", second = 400, content = Content.NO_SAMPLES)
    val foreign = entry("groceries.csv", content = Content.NO_LOG)
    val state = LibraryState().knowing(listOf(bench, match9, reboot, match10, foreign))

    val anyEntry = arbitrary {
        val number = Arb.int(1..99).orNull().bind()?.toString()
        val name = Arb.string(1..8).bind().filter { it.isLetterOrDigit() }
        entry("${name}x.bag", MatchOfLog(number = number), Arb.int(0..5).bind().toLong(), batteryMinimum = number?.toDouble())
    }

    test("the newest stands at the top, and what is not a log does not stand there") {
        names(state) shouldContainExactly listOf("reboot.bag", "a.bag", "b.bag", "bench.csv")
    }

    test("the newest log is one in which something happened") {
        state.newest shouldBe match9
        LibraryState().knowing(listOf(reboot)).newest shouldBe reboot
        LibraryState().newest.shouldBeNull()
    }

    test("a table of numbers is the newest log only where there is no robot's log") {
        val table = entry("elevator-bench.csv", second = 900)
        LibraryState().knowing(listOf(table, match9, bench)).newest shouldBe match9
        LibraryState().knowing(listOf(table, reboot)).newest shouldBe reboot
        LibraryState().knowing(listOf(table, bench)).newest shouldBe table
    }

    test("match 9 comes before match 10, and what is not a match comes last either way round") {
        val byNumber = state.sorted(LogColumn.NUMBER)
        names(byNumber) shouldContainExactly listOf("a.bag", "b.bag", "reboot.bag", "bench.csv")
        names(byNumber.sorted(LogColumn.NUMBER)) shouldContainExactly listOf("b.bag", "a.bag", "reboot.bag", "bench.csv")
    }

    test("sorting loses and adds nothing, and puts what is missing last") {
        checkAll(Arb.list(anyEntry, 0..30), Arb.enum<LogColumn>(), Arb.int(1..2)) { entries, column, clicks ->
            val distinct = entries.distinctBy { it.file }
            val sorted = (1..clicks).fold(LibraryState().knowing(distinct)) { state, _ -> state.sorted(column) }.visible
            sorted shouldContainExactlyInAnyOrder distinct
            sorted.dropWhile { column.has(it) }.none { column.has(it) } shouldBe true
            for (entry in sorted) (column.text(entry) != null) shouldBe column.has(entry)
        }
    }

    test("all words must be found, anywhere, in whatever case") {
        names(state.filtered("qual RED")) shouldContainExactly listOf("a.bag")
        names(state.filtered("mill 10")) shouldContainExactly listOf("b.bag")
        names(state.filtered("day2")) shouldContainExactly listOf("bench.csv")
        names(state.filtered("  ")).size shouldBe 4
        names(state.filtered("1970-01-01")).size shouldBe 4
        names(state.filtered("logs nothing")).size shouldBe 0
    }

    test("what is empty can be left out") {
        names(state.hidingEmpty(true)) shouldContainExactly listOf("a.bag", "b.bag", "bench.csv")
    }

    test("steps go along the list as it is shown, and stop at its ends") {
        val shown = state.hidingEmpty(true)
        shown.stepped(1) shouldBe match9
        shown.stepped(-1) shouldBe bench
        shown.copy(selected = match9.file).stepped(1) shouldBe match10
        shown.copy(selected = match9.file).stepped(-1) shouldBe match9
        shown.copy(selected = match9.file).stepped(100) shouldBe bench
        LibraryState().stepped(1).shouldBeNull()
    }

    test("another folder is listed as the one before, from its beginning") {
        val next = state.sorted(LogColumn.SIZE).hidingEmpty(true).filtered("mill").opening(match9.file.parent)
        next.listing.column shouldBe LogColumn.SIZE
        next.listing.hidesEmpty shouldBe true
        next.listing.filter shouldBe ""
        next.visible shouldBe emptyList<LogEntry>()
    }
})
