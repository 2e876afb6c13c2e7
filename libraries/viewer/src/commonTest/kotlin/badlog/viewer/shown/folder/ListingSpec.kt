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
import badlog.viewer.catalog.Verdict
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
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

    test("match 9 is before match 10, and logs without a match are last in either order, sorted by name") {
        val byMatch = listing.sorted(LogColumn.MATCH)
        names(byMatch) shouldContainExactly listOf("a.bag", "b.bag", "bench.csv", "reboot.bag")
        names(byMatch.sorted(LogColumn.MATCH)) shouldContainExactly listOf("b.bag", "a.bag", "reboot.bag", "bench.csv")
    }

    test("logs of one match are one row, at the place of the first of them") {
        val station = log("logs/9.dslog", MatchOfLog(null, "Qualification", "9"), 150)
        val rows = Listing(listOf(match10, match9, station, bench)).rows
        rows.map { row -> row.logs.map { it.fileName } } shouldBe listOf(listOf("9.dslog", "a.bag"), listOf("b.bag"), listOf("bench.csv"))
        val ascending = Listing(listOf(match10, match9, station, bench), isDescending = false).rows
        ascending.map { it.worst.fileName } shouldBe listOf("bench.csv", "a.bag", "b.bag")
    }

    test("a list has the title of the match in few letters, and a search finds it") {
        shortTitle(MatchOfLog("Mill Creek Regional", "Qualification", "42")) shouldBe "Q42 · Mill Creek"
        shortTitle(MatchOfLog("OHCL", "Semifinal", "2-1")) shouldBe "SF2-1 · OHCL"
        shortTitle(MatchOfLog(null, "Exhibition", "3")) shouldBe "Exhibition 3"
        shortTitle(MatchOfLog(null, null, "3")) shouldBe "Match 3"
        shortTitle(MatchOfLog("OHCL")) shouldBe "OHCL"
        shortTitle(MatchOfLog()) shouldBe null
        names(listing.copy(filter = "q10")) shouldContainExactly listOf("b.bag")
    }

    test("a long file name loses whole words in its middle; a single long word is left whole") {
        shortFileName("FRC_20260307_163005_OHCL_Q57.bag.gz") shouldBe "FRC_20260307_163005_OHCL_Q57.bag.gz"
        shortFileName("practice/FRC_20260307_163005_OHCL_Q57.bag.gz") shouldBe "practice/FRC_…163005_OHCL_Q57.bag.gz"
        shortFileName("a".repeat(50)) shouldBe "a".repeat(50)
        checkAll(Arb.list(Arb.int(1..9), 1..12)) { lengths ->
            val words = lengths.map { "abcdefghi".take(it) }
            val name = words.joinToString("_")
            val short = shortFileName(name)
            short.length shouldBeLessThanOrEqual maxOf(36, if (short == name) name.length else 0)
            words shouldContainAll short.split('_', '…').filter { it.isNotEmpty() }
        }
    }

    test("sorted by match, the logs of one event are together") {
        val other = log("logs/c.bag", MatchOfLog("Beta District", "Qualification", "1", "Red"), 250)
        val all = Listing(listOf(match10, other, match9, bench), folder = "logs")
        names(all) shouldContainExactly listOf("a.bag", "c.bag", "b.bag", "bench.csv")
        names(all.sorted(LogColumn.MATCH)) shouldContainExactly listOf("c.bag", "a.bag", "b.bag", "bench.csv")
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

    test("the text of findings is the main sentence, or the worst name, and the number of others, … while the rules run, and – if they cannot") {
        val two = listOf(FoundRule("Browned out", Severity.ERROR), FoundRule("Loop slow", Severity.WARNING))
        foundText(log("a.bag", found = two)) shouldBe "Browned out +1"
        foundText(log("a.bag")) shouldBe null
        val verdict = Verdict(Severity.ERROR, "Browned out at 1:33", listOf("It browned out."))
        foundText(log("a.bag").copy(found = FindingSummary(0, two, verdict))) shouldBe "Browned out at 1:33 +1"
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
