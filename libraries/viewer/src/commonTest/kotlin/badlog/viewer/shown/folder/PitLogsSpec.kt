package badlog.viewer.shown.folder

import badlog.core.recording.Severity
import badlog.signals.match.MatchOfLog
import badlog.viewer.catalog.Content
import badlog.viewer.catalog.DateSource
import badlog.viewer.catalog.FindingSummary
import badlog.viewer.catalog.FoundRule
import badlog.viewer.catalog.LogDate
import badlog.viewer.catalog.LogSummary
import badlog.viewer.catalog.Verdict
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class PitLogsSpec : FunSpec({
    val error = FindingSummary(0, listOf(FoundRule("Browned out", Severity.ERROR)), Verdict(Severity.ERROR, "Browned out at 1:33", listOf("It sagged.")))

    fun log(path: String, second: Long, match: String? = null, found: FindingSummary? = FindingSummary(0, emptyList()), content: Content = Content.SOMETHING) = AnyLog(path, LogSummary(MatchOfLog("Mill Creek", match?.let { "Qualification" }, match), LogDate(second, DateSource.VALUES), content = content), found)

    fun pit(vararg logs: AnyLog) = PitLogs.of(logs.toList())

    test("a pit sees the last log and the three before it, the latest first") {
        val pit = pit(log("b", 2), log("e", 5), log("a", 1), log("d", 4), log("c", 3))
        pit?.last?.path shouldBe "e"
        pit?.before?.map { it.path } shouldBe listOf("d", "c", "b")
    }

    test("idle logs and unreadable files are left out") {
        pit(log("idle", 9, content = Content.NO_SAMPLES)) shouldBe null
        pit(log("idle", 9, content = Content.NO_SAMPLES), log("a", 1))?.last?.path shouldBe "a"
    }

    test("a pit sees the one with the worst finding of two logs of a match, and lists distinguish them by their files") {
        val robot = log("robot", 10, "42", error)
        val station = log("station", 11, "42")
        val other = log("other", 5, "41")
        pit(robot, station, other)?.run { last.path to before.map { it.path } } shouldBe ("robot" to listOf("other"))
    }

    test("a replayed match, and the same number at another event, are other runs") {
        val replayed = listOf(log("first", 0, "42", error), log("again", 7200, "42"))
        runsOf(replayed).map { it.worst.path } shouldBe listOf("again", "first")
        val elsewhere = log("x", 20, "42").run { copy(summary = summary.copy(match = MatchOfLog("Beta", "Qualification", "42"))) }
        isOfSameRun(log("y", 10, "42"), elsewhere) shouldBe false
        val unnamed = log("x", 20, "42").run { copy(summary = summary.copy(match = MatchOfLog(null, "Qualification", "42"))) }
        isOfSameRun(log("y", 10, "42"), unnamed) shouldBe true
    }

    test("logs of robots have names of logs, tables count without any, and unreadable files never do") {
        val unreadable = log("broken.bag", 1).run { copy(summary = summary.copy(trouble = "broken.bag is cut off.")) }
        fun robots(vararg logs: AnyLog) = logsOfRobots(logs.toList()) { it.endsWith(".bag") }.map { it.path }
        robots(log("a.bag", 1), log("b.csv", 2), unreadable) shouldBe listOf("a.bag")
        robots(log("b.csv", 2), unreadable) shouldBe listOf("b.csv")
    }

    test("an empty pit view gives the reason: no logs, none of an enabled robot, or none read yet") {
        pitEmptiness(emptyList(), isReading = false) shouldBe "No log yet."
        pitEmptiness(listOf(log("idle", 9, content = Content.NO_SAMPLES)), isReading = false) shouldBe "No log of an enabled robot yet."
        pitEmptiness(listOf(log("idle", 9, content = Content.NO_SAMPLES)), isReading = true) shouldBe "Reading the first logs…"
    }

    test("a log has its facts in a few words") {
        verdictText(null) shouldBe "The rules are still running"
        verdictText(FindingSummary(0, null)) shouldBe "The rules could not be run"
        verdictText(FindingSummary(0, emptyList())) shouldBe "No errors, no warnings"
        verdictText(error) shouldBe "Browned out at 1:33"
    }
})
