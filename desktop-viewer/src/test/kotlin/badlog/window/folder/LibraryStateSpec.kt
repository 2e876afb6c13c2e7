package badlog.window.folder

import badlog.catalog.folder.LogEntry
import badlog.catalog.folder.entry
import badlog.signals.match.MatchOfLog
import badlog.viewer.catalog.Content
import badlog.viewer.catalog.FindingSummary
import badlog.viewer.shown.folder.LogColumn
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.shouldBe

class LibraryStateSpec : FunSpec({
    val match9 = entry("a.bag", MatchOfLog("Mill Creek Regional", "Qualification", "9", "Red"), 300)
    val match10 = entry("b.bag", MatchOfLog("Mill Creek Regional", "Qualification", "10", "Blue"), 200)
    val bench = entry("day2/bench.csv", second = 100)
    val reboot = entry("reboot.bag", second = 400, content = Content.NO_SAMPLES)
    val foreign = entry("groceries.csv", content = Content.NO_LOG)
    val state = LibraryState().withEntries(listOf(bench, match9, reboot, match10, foreign))

    test("the newest log is not an idle one, unless all are idle") {
        state.newest shouldBe match9
        LibraryState().withEntries(listOf(reboot)).newest shouldBe reboot
        LibraryState().newest.shouldBeNull()
    }

    test("a table of numbers is the newest log only if there is no robot's log") {
        val table = entry("elevator-bench.csv", second = 900)
        LibraryState().withEntries(listOf(table, match9, bench)).newest shouldBe match9
        LibraryState().withEntries(listOf(table, reboot)).newest shouldBe reboot
        LibraryState().withEntries(listOf(table, bench)).newest shouldBe table
    }

    test("steps follow the order of the list, and stop at its ends") {
        val shown = state.hidingEmpty(true)
        shown.stepped(1) shouldBe match9
        shown.stepped(-1) shouldBe bench
        shown.copy(selected = match9.file).stepped(1) shouldBe match10
        shown.copy(selected = match9.file).stepped(-1) shouldBe match9
        shown.copy(selected = match9.file).stepped(100) shouldBe bench
        LibraryState().stepped(1).shouldBeNull()
    }

    test("a log that has grown is being recorded, until the rules have run over it") {
        val running = match9.copy(found = null)
        val grown = running.copy(source = running.source.copy(size = running.size + 1))
        val before = LibraryState().withEntries(listOf(running))
        before.listing.recording shouldBe emptySet()
        val growing = before.withEntries(listOf(grown))
        growing.listing.recording shouldBe setOf(grown.path)
        growing.withEntries(listOf(grown)).listing.recording shouldBe setOf(grown.path)
        growing.withEntries(listOf(grown.copy(found = FindingSummary(0, emptyList())))).listing.recording shouldBe emptySet()
    }

    test("an idle log over which no rule ever runs is recorded only while it grows; another folder begins with none") {
        val grown = reboot.copy(source = reboot.source.copy(size = reboot.source.size + 1), found = null)
        val growing = state.withEntries(listOf(grown))
        growing.listing.recording shouldBe setOf(grown.path)
        growing.withEntries(listOf(grown)).listing.recording shouldBe emptySet()
        growing.opening(match9.file.parent).listing.recording shouldBe emptySet()
    }

    test("another folder is listed like the previous one, from its beginning") {
        val next = state.sorted(LogColumn.SIZE).hidingEmpty(true).filtered("mill").opening(match9.file.parent)
        next.listing.column shouldBe LogColumn.SIZE
        next.listing.hidesEmpty shouldBe true
        next.listing.filter shouldBe ""
        next.visible shouldBe emptyList<LogEntry>()
    }
})
