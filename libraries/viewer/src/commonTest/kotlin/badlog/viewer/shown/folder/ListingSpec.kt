package badlog.viewer.shown.folder

import badlog.core.recording.Severity
import badlog.signals.battery.BatteryUse
import badlog.signals.match.MatchOfLog
import badlog.viewer.catalog.Content
import badlog.viewer.catalog.DateSource
import badlog.viewer.catalog.FindingSummary
import badlog.viewer.catalog.FoundRule
import badlog.viewer.catalog.ListedLog
import badlog.viewer.catalog.LogDate
import badlog.viewer.catalog.LogSummary
import badlog.viewer.catalog.ProblemCounts
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.arbitrary
import io.kotest.property.arbitrary.enum
import io.kotest.property.arbitrary.int
import io.kotest.property.arbitrary.list
import io.kotest.property.arbitrary.orNull
import io.kotest.property.checkAll

internal data class AnyLog(
    override val path: String,
    override val summary: LogSummary,
    override val found: FindingSummary?,
    override val size: Long = 1000,
    override val modified: Long = 0,
) : ListedLog {
    override val fileName get() = path.substringAfterLast('/')
}

class ListingSpec : FunSpec({
    test("the heading says that a shown log is not listed, because it was deleted or is of another folder") {
        headingOf("Qualification 42", isListed = true) shouldBe "Qualification 42"
        headingOf("Qualification 42", isListed = false) shouldBe "Qualification 42 · not in the list"
    }

    test("the count says how many pages of a folder are not listed") {
        Listing<ListedLog>(pages = 2).count shouldBe "0 logs · 2 pages left out: open one alone"
        Listing<ListedLog>(pages = 1).count shouldBe "0 logs · 1 page left out: open one alone"
    }

    fun log(
        path: String,
        match: MatchOfLog = MatchOfLog(),
        second: Long = 0,
        content: Content = Content.SOMETHING,
        battery: Double? = null,
        found: List<FoundRule> = emptyList(),
    ) = AnyLog(
        path,
        LogSummary(match, LogDate(second, DateSource.VALUES), content = content, battery = BatteryUse(lowest = battery)),
        FindingSummary(0, found).takeIf { content == Content.SOMETHING },
    )

    val match9 = log("logs/a.bag", MatchOfLog("Mill Creek Regional", "Qualification", "9", "Red"), 300, found = listOf(FoundRule("Browned out", Severity.ERROR)))
    val match10 = log("logs/b.bag", MatchOfLog("Mill Creek Regional", "Qualification", "10", "Blue"), 200)
    val bench = log("logs/day2/bench.csv", second = 100)
    val reboot = log("logs/reboot.bag", second = 400, content = Content.NO_SAMPLES)
    val foreign = log("logs/groceries.csv", content = Content.NO_LOG)
    val listing = Listing(listOf(bench, match9, reboot, match10, foreign), folder = "logs")

    fun names(listing: Listing<AnyLog>) = listing.visible.map { it.fileName }

    test("the newest log is at the top, and a file that is not a log is not listed") {
        names(listing) shouldContainExactly listOf("reboot.bag", "a.bag", "b.bag", "bench.csv")
        listing.size shouldBe 4
        listing.count shouldBe "4 logs"
        listing.copy(filter = "bench").count shouldBe "1 of 4 logs"
    }

    test("match 9 is before match 10, and logs without a match are last in either order") {
        val byNumber = listing.sorted(LogColumn.NUMBER)
        names(byNumber) shouldContainExactly listOf("a.bag", "b.bag", "reboot.bag", "bench.csv")
        names(byNumber.sorted(LogColumn.NUMBER)) shouldContainExactly listOf("b.bag", "a.bag", "reboot.bag", "bench.csv")
    }

    test("logs of one event are together, in the order of the first log of each") {
        val other = log("logs/c.bag", MatchOfLog("Beta District", "Qualification", "1", "Red"), 250)
        val all = Listing(listOf(match10, other, match9, bench), folder = "logs")
        names(all) shouldContainExactly listOf("a.bag", "c.bag", "b.bag", "bench.csv")
        names(all.copy(groupsEvents = true)) shouldContainExactly listOf("a.bag", "b.bag", "c.bag", "bench.csv")
        all.events shouldBe 2
    }

    test("all words must occur, regardless of case, anywhere but in the folder's own name, including findings") {
        names(listing.copy(filter = "qual RED")) shouldContainExactly listOf("a.bag")
        names(listing.copy(filter = "mill 10")) shouldContainExactly listOf("b.bag")
        names(listing.copy(filter = "day2")) shouldContainExactly listOf("bench.csv")
        names(listing.copy(filter = "browned")) shouldContainExactly listOf("a.bag")
        names(listing.copy(filter = "1970-01-01")).size shouldBe 4
        names(listing.copy(filter = "  ")).size shouldBe 4
        names(listing.copy(filter = "logs")).size shouldBe 0
    }

    test("idle logs, and logs without errors, can be hidden") {
        names(listing.copy(hidesEmpty = true)) shouldContainExactly listOf("a.bag", "b.bag", "bench.csv")
        names(listing.copy(onlyErrors = true)) shouldContainExactly listOf("a.bag")
    }

    test("an empty list has a reason, the words before the hidden logs") {
        listing.copy(filter = " nothing ", onlyErrors = true).emptiness shouldBe "No log matches “nothing”."
        listing.copy(onlyErrors = true, hidesEmpty = true).emptiness shouldBe "Rules found no error in any of these logs."
        listing.copy(hidesEmpty = true).emptiness shouldBe "All of these logs are idle."
        val onlyErrors = Listing(listOf(bench, match9.copy(found = null), bench.copy(found = FindingSummary(0, null)), match10), onlyErrors = true)
        onlyErrors.emptiness shouldBe "Rules found no error, but have not run over 2 of these logs."
        onlyErrors.copy(entries = onlyErrors.entries.map { it.copy(found = null) }).emptiness shouldBe
            "Rules have not run over any of these logs."
    }

    test("sorting loses and adds nothing, puts missing values last, and a column has a text for each value") {
        val anyLog = arbitrary {
            val number = Arb.int(1..99).orNull().bind()?.toString()
            val second = Arb.int(0..5).bind().toLong()
            log("x${Arb.int(0..999).bind()}.bag", MatchOfLog(number = number), second, battery = number?.toDouble())
        }
        checkAll(Arb.list(anyLog, 0..30), Arb.enum<LogColumn>(), Arb.int(1..2)) { logs, column, clicks ->
            val distinct = logs.distinctBy { it.path }
            val sorted = (1..clicks).fold(Listing(distinct)) { listing, _ -> listing.sorted(column) }.visible
            sorted shouldContainExactlyInAnyOrder distinct
            sorted.dropWhile { column.has(it) }.none { column.has(it) } shouldBe true
            for (log in sorted) (column.text(log) != null) shouldBe column.has(log)
        }
    }

    test("the battery's lowest voltage is rounded down, so that it does not look better than it was") {
        LogColumn.BATTERY.text(log("a.bag", battery = 6.799)) shouldBe "6.79 V"
        LogColumn.BATTERY.text(log("a.bag", battery = 6.8)) shouldBe "6.80 V"
    }

    test("the text of findings is the worst name and the number of others, … while the rules run, and – if they cannot") {
        val two = listOf(FoundRule("Browned out", Severity.ERROR), FoundRule("Loop slow", Severity.WARNING))
        foundText(log("a.bag", found = two)) shouldBe "Browned out +1"
        foundText(log("a.bag")) shouldBe null
        foundText(log("a.bag").copy(found = null)) shouldBe "…"
        foundText(log("a.bag").copy(found = FindingSummary(0, null))) shouldBe "–"
        foundLines(log("a.bag", found = two)) shouldBe "error: Browned out\nwarning: Loop slow"
    }

    test("a log has the severity of its worst problem that matters, and an unreadable log is an error") {
        fun severityOf(problems: ProblemCounts, trouble: String? = null) = match9.copy(summary = match9.summary.copy(problems = problems, trouble = trouble)).problemSeverity
        severityOf(ProblemCounts(notes = 3)) shouldBe null
        severityOf(ProblemCounts(warnings = 2, notes = 3)) shouldBe Severity.WARNING
        severityOf(ProblemCounts(errors = 1, warnings = 2)) shouldBe Severity.ERROR
        severityOf(ProblemCounts(), trouble = "It cannot be read.") shouldBe Severity.ERROR
    }
})
