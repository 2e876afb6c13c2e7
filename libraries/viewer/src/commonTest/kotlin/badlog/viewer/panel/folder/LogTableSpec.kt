package badlog.viewer.panel.folder

import badlog.core.analysis.SeriesStatistics
import badlog.core.recording.Severity
import badlog.core.recording.TopicKind
import badlog.signals.battery.BatteryUse
import badlog.signals.match.MatchOfLog
import badlog.viewer.catalog.Content
import badlog.viewer.catalog.DateSource
import badlog.viewer.catalog.FindingSummary
import badlog.viewer.catalog.FoundRule
import badlog.viewer.catalog.LogDate
import badlog.viewer.catalog.LogSummary
import badlog.viewer.catalog.PreviewLine
import badlog.viewer.catalog.ProblemCounts
import badlog.viewer.catalog.TopicSummary
import badlog.viewer.catalog.Verdict
import badlog.viewer.panel.Cell
import badlog.viewer.panel.Table
import badlog.viewer.shown.folder.AnyLog
import badlog.viewer.shown.folder.Listing
import badlog.viewer.shown.folder.LogColumn
import badlog.viewer.state.FolderAction
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.types.shouldBeInstanceOf

class LogTableSpec : FunSpec({
    val morning = 1_710_585_660L
    val volts = TopicSummary("Volts", "V", TopicKind.NUMERIC, SeriesStatistics(2, 0, 7.0, 13.0, 10.0, 3.0, 7.0, 10.0, 13.0, 13.0, 7.0, 20.0), PreviewLine.NONE)

    fun log(path: String, number: String? = null, event: String? = null, second: Long = morning, battery: Double? = null, content: Content = Content.SOMETHING) = AnyLog(
        path,
        LogSummary(
            MatchOfLog(event, number?.let { "Qualification" }, number),
            LogDate(second, DateSource.VALUES),
            duration = 156.0,
            content = content,
            battery = battery?.let { BatteryUse(topic = "Volts", lowest = it) },
            topics = listOf(volts),
        ),
        FindingSummary(0, emptyList()),
        modified = 1,
    )

    val brownout = FindingSummary(
        0,
        listOf(FoundRule("Browned out", Severity.ERROR), FoundRule("Loop slow", Severity.WARNING)),
        Verdict(Severity.ERROR, "Browned out at 1:33", listOf("It browned out.")),
    )
    val robot = log("logs/robot.bag", "42", "Mill Creek Regional", battery = 6.73).copy(found = brownout)
    val station = log("logs/station.dslog", "42", second = morning - 60)
    val practice = log("logs/practice.bag", second = morning - 7200, battery = 12.1)
    val yesterday = log("logs/bench.csv", second = morning - 86_400)

    fun table(vararg logs: AnyLog, change: Listing<AnyLog>.() -> Listing<AnyLog> = { this }) = logTable(Listing(logs.toList(), folder = "logs").change(), emptySet())
    fun Table.cells(row: Int, column: LogColumn): List<Cell> {
        val at = columns.indexOfFirst { it.key == column.name }
        return if (at < 0) emptyList() else groups.flatMap { it.rows }[row].cells[at]
    }
    fun Table.texts(row: Int) = groups.flatMap { it.rows }[row].cells.map { cells -> cells.joinToString { it.text } }
    fun Cell.opens() = open.shouldBeInstanceOf<FolderAction.Open>().run { path to showsFinding }

    test("a row begins with the match and what happened, and ends with the files; empty columns are left out") {
        val table = table(robot, station, practice)
        table.columns.map { it.title } shouldBe listOf("Match", "What happened", "Time", "Duration", "Lowest battery", "Samples", "Size", "File")
        table.texts(0) shouldBe
            listOf("Q42 · Mill Creek", "Browned out at 1:33 +1", "10:41", "2:36", "6.73 V", "0", "1.0 kB", "robot.bag, station.dslog")
        table.texts(1) shouldBe listOf("practice.bag", "", "08:41", "2:36", "12.10 V", "0", "1.0 kB", "")
    }

    test("without room for all columns, alliance, samples and size are left out, each with its cells") {
        val narrow = table(robot, station, practice).withoutMinor()
        narrow.columns.map { it.title } shouldBe listOf("Match", "What happened", "Time", "Duration", "Lowest battery", "File")
        narrow.texts(0) shouldBe listOf("Q42 · Mill Creek", "Browned out at 1:33 +1", "10:41", "2:36", "6.73 V", "robot.bag, station.dslog")
        narrow.groups.single().count shouldBe "3 logs"
    }

    test("a click on a row opens the log with the worst finding, one on what happened its evidence, and one on a file that file") {
        val table = table(robot, station)
        table.groups.single().rows.single().open.shouldBeInstanceOf<FolderAction.Open>().run { path to showsFinding } shouldBe ("logs/robot.bag" to false)
        table.cells(0, LogColumn.FINDINGS).single().opens() shouldBe ("logs/robot.bag" to true)
        table.cells(0, LogColumn.FILE).map { it.opens().first } shouldBe listOf("logs/robot.bag", "logs/station.dslog")
        table.cells(0, LogColumn.FINDINGS).single().run { severity to hint } shouldBe (Severity.ERROR to "error: Browned out\nwarning: Loop slow")
    }

    test("each readable log of a match can be checked") {
        val broken = log("logs/x.bag", "42").run { copy(summary = summary.copy(trouble = "It cannot be read.", content = Content.UNREADABLE)) }
        val listing = Listing(listOf(robot, station, broken), folder = "logs")
        val checks = logTable(listing, setOf("logs/station.dslog")).groups.single().rows.single().checks
        checks.map { it.label to it.isOn } shouldBe listOf("Compare robot.bag" to false, "Compare station.dslog" to true)
        checks.last().action.shouldBeInstanceOf<FolderAction.Check>().path shouldBe "logs/station.dslog"
    }

    test("logs sorted by time are grouped by day, those sorted by match by event; other orders have no groups") {
        val groups = table(robot, station, practice, yesterday).groups
        groups.map { it.title to it.count } shouldBe listOf("16 Mar 2024" to "3 logs", "15 Mar 2024" to "1 log")
        groups.map { group -> group.rows.map { it.key } } shouldBe listOf(listOf("logs/robot.bag", "logs/practice.bag"), listOf("logs/bench.csv"))
        val bySize = table(robot, practice, yesterday) { sorted(LogColumn.SIZE) }
        bySize.groups.map { it.title } shouldBe listOf("")
        bySize.cells(0, LogColumn.DATE).single().text shouldBe "16 Mar 2024, 10:41"
        table(robot, practice) { sorted(LogColumn.MATCH) }.groups.map { it.title } shouldBe listOf("Mill Creek Regional", "No event")
    }

    test("an idle or unreadable log, even a later one, does not stand for a match with another log") {
        val found = robot.copy(found = FindingSummary(0, emptyList()))
        val idle = log("logs/later.bag", "42", second = morning + 60, content = Content.NOTHING_CHANGES).copy(modified = 9)
        table(found, idle).groups.single().rows.single().run { key to isMuted } shouldBe ("logs/robot.bag" to false)
    }

    test("a match has the longest duration and the lowest voltage of its logs, and without findings it opens the log with the most samples") {
        val other = station.run { copy(summary = summary.copy(duration = 170.0, battery = BatteryUse(lowest = 6.1)), modified = 9) }
        val table = table(robot.run { copy(summary = summary.copy(samples = 100), found = null) }, other.copy(found = null))
        table.cells(0, LogColumn.DURATION).map { it.text } shouldBe listOf("2:50")
        table.cells(0, LogColumn.BATTERY).map { it.text } shouldBe listOf("6.10 V")
        table.cells(0, LogColumn.MATCH).single().opens().first shouldBe "logs/robot.bag"
    }

    test("a match has the event that one of its logs names, in its title and its group") {
        val worst = station.copy(found = brownout)
        val named = robot.copy(found = FindingSummary(0, emptyList()))
        val table = table(worst, named) { sorted(LogColumn.MATCH) }
        table.groups.map { it.title } shouldBe listOf("Mill Creek Regional")
        table.cells(0, LogColumn.MATCH).single().run { text to opens().first } shouldBe ("Q42 · Mill Creek" to "logs/station.dslog")
    }

    test("the order of the rows is that of the list, also where a group without an event stands between others") {
        val logs = listOf(robot, log("logs/b.bag", "42", second = morning - 9000), log("logs/c.bag", "43", "Mill Creek Regional"), log("logs/d.bag", "43", second = morning - 9000))
        val listing = Listing(logs).sorted(LogColumn.MATCH)
        logTable(listing, emptySet()).groups.flatMap { it.rows }.map { it.key } shouldBe listing.rows.map { it.worst.path }
    }

    test("a limit leaves out the last rows, and groups without rows, but not from the counts") {
        val groups = logTable(Listing(listOf(robot, practice, yesterday)), emptySet(), limit = 1).groups
        groups.map { it.count to it.rows.size } shouldBe listOf("2 logs" to 1)
    }

    test("the column by which the logs are sorted says so, and a press on a title sorts by it") {
        val columns = table(robot) { sorted(LogColumn.BATTERY) }.columns
        columns.filter { it.isDescending != null }.map { it.key to it.isDescending } shouldBe listOf("BATTERY" to false)
        columns.map { it.sort.shouldBeInstanceOf<FolderAction.Sort>().column.name } shouldBe columns.map { it.key }
    }

    test("the lowest battery is a bar from 5 to 13 V, red near a brownout") {
        fun bar(volts: Double) = table(log("a.bag", battery = volts)).cells(0, LogColumn.BATTERY).single().run { share to severity }
        bar(9.0) shouldBe (0.5 to null)
        bar(6.9).second shouldBe Severity.ERROR
        bar(13.7).first shouldBe 1.0
        bar(0.0).first shouldBe 0.0
    }

    test("a log that is being written, or idle, says so instead of what happened; one that is elsewhere says nothing") {
        fun happened(log: AnyLog, change: Listing<AnyLog>.() -> Listing<AnyLog> = { this }) = table(log, change = change).cells(0, LogColumn.FINDINGS).map { it.text }
        happened(practice.copy(found = null)) shouldBe listOf("…")
        happened(practice.copy(found = null)) { copy(recording = setOf("logs/practice.bag")) } shouldBe listOf("recording")
        happened(log("a.bag", content = Content.NOTHING_CHANGES)) shouldBe listOf("idle log")
        table(log("a.bag", content = Content.NOTHING_CHANGES)).groups.single().rows.single().isMuted shouldBe true
        happened(practice).shouldBeEmpty()
    }

    test("rows that did not change are equal, with their previews, so that nothing draws them again") {
        fun rows(vararg logs: AnyLog) = table(*logs).withPreviews(logs.toList(), name = null).groups.flatMap { it.rows }
        rows(robot, practice) shouldBe rows(robot, practice)
        val (changed, same) = rows(robot.copy(found = null), practice)
        (changed == rows(robot, practice).first()) shouldBe false
        same shouldBe rows(robot, practice).last()
    }

    test("problems have a severity, and the sentence as a hint") {
        val damaged = practice.run { copy(summary = summary.copy(problems = ProblemCounts(warnings = 2))) }
        table(damaged).cells(0, LogColumn.PROBLEMS).single().run { Triple(text, severity, hint) } shouldBe Triple("2 problems", Severity.WARNING, "2 warnings")
    }

    test("previews follow the battery, all with the same range, and take the battery’s voltage by default") {
        val logs = listOf(robot, practice.copy(summary = practice.summary.copy(battery = null)))
        val table = logTable(Listing(logs), emptySet()).withPreviews(logs, name = null)
        table.columns.map { it.key }.let { it.indexOf("PREVIEW") - it.indexOf("BATTERY") } shouldBe 1
        table.columns.single { it.key == "PREVIEW" }.run { title to sort } shouldBe ("Voltage" to null)
        val previews = table.groups.single().rows.map { row -> row.cells[table.columns.indexOfFirst { it.key == "PREVIEW" }] }
        previews.map { cells -> cells.map { it.preview?.topic?.name } } shouldBe listOf(listOf("Volts"), emptyList())
        previews.first().single().preview?.range.run { this?.from to this?.to } shouldBe (7.0 to 13.0)
    }
})
