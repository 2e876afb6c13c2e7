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

class ArrivalsSpec : FunSpec({
    val date = LogDate(0, DateSource.VALUES)
    val summary = LogSummary(date = date, content = Content.SOMETHING)
    val nothing = FindingSummary(0, emptyList())

    fun log(path: String, size: Long = 1000, found: FindingSummary? = nothing, modified: Long = 0, of: LogSummary = summary) = AnyLog(path, of, found, size, modified)

    fun Arrivals<AnyLog>.paths() = waiting.map { it.path }
    val opened = Arrivals<AnyLog>().begun(mapOf("a.bag" to 1000L, "b.bag" to 1000L))

    test("files that were in the folder before do not arrive, even if they are read or rules run later") {
        Arrivals<AnyLog>().withEntries(listOf(log("a.bag"))).paths() shouldBe emptyList()
        opened.withEntries(listOf(log("a.bag"))).paths() shouldBe emptyList()
        opened.withEntries(listOf(log("a.bag"), log("b.bag"))).paths() shouldBe emptyList()
    }

    test("a log is new until it has arrived") {
        Arrivals<AnyLog>().isNew(log("a.bag")) shouldBe false
        opened.isNew(log("a.bag")) shouldBe false
        opened.isNew(log("a.bag", size = 2000, found = null)) shouldBe true
        opened.isNew(log("c.bag", found = null)) shouldBe true
        opened.withEntries(listOf(log("c.bag"))).isNew(log("c.bag")) shouldBe false
    }

    test("a log arrives after the rules have run over it, and waits until a person opens or postpones it") {
        val copied = opened.withEntries(listOf(log("a.bag"), log("c.bag", found = null)))
        copied.paths() shouldBe emptyList()
        val complete = copied.withEntries(listOf(log("a.bag"), log("c.bag")))
        complete.latest?.worst?.path shouldBe "c.bag"
        complete.withEntries(listOf(log("a.bag"), log("c.bag"), log("d.bag", modified = 1))).paths() shouldBe listOf("c.bag", "d.bag")
        complete.dealtWith().withEntries(listOf(log("a.bag"), log("c.bag"))).paths() shouldBe emptyList()
        complete.without("c.bag").paths() shouldBe emptyList()
    }

    test("a log that was being written arrives once, after it has grown and ended, and stays known while it grows again") {
        val grown = opened.withEntries(listOf(log("a.bag", size = 2000, found = null)))
        grown.paths() shouldBe emptyList()
        val ended = grown.withEntries(listOf(log("a.bag", size = 3000)))
        ended.paths() shouldBe listOf("a.bag")
        val again = ended.withEntries(listOf(log("a.bag", size = 3500, found = null)))
        again.waiting shouldBe ended.waiting
        again.withEntries(listOf(log("a.bag", size = 4000))).waiting.map { it.size } shouldBe listOf(4000L)
        ended.dealtWith().withEntries(listOf(log("a.bag", size = 5000))).paths() shouldBe emptyList()
    }

    test("the log with the worst finding is announced of several logs of one match") {
        val match = LogSummary(MatchOfLog(null, "Qualification", "78"), date, content = Content.SOMETHING)
        val worse = FindingSummary(0, listOf(FoundRule("Browned out", Severity.ERROR)))
        val arrived = opened.withEntries(listOf(log("robot.bag", found = worse, of = match), log("station.dslog", modified = 1, of = match), log("x.bag")))
        arrived.latest?.run { worst.path to logs.size } shouldBe ("robot.bag" to 2)
    }

    test("a removed log no longer waits, and a waiting one shows the findings of other rules") {
        val arrived = opened.withEntries(listOf(log("c.bag"), log("d.bag", modified = 1)))
        val otherwise = FindingSummary(1, listOf(FoundRule("Hot motor", Severity.WARNING)))
        val after = arrived.withEntries(listOf(log("d.bag", found = otherwise, modified = 1)))
        after.waiting.single().found shouldBe otherwise
    }

    test("idle logs and files that cannot be read do not arrive") {
        val idle = log("idle.bag", of = LogSummary(date = date, content = Content.NO_SAMPLES))
        val broken = log("broken.bag", of = LogSummary.unreadable("broken.bag", 0, "It cannot be read."))
        opened.withEntries(listOf(idle, broken)).paths() shouldBe emptyList()
    }

    test("the sentence has the match, the severities and the event") {
        val match = LogSummary(MatchOfLog(null, "Qualification", "78"), date, content = Content.SOMETHING)
        val rules = listOf(FoundRule("Browned out", Severity.ERROR), FoundRule("Hot motor", Severity.WARNING))
        val found = FindingSummary(0, rules, Verdict(Severity.ERROR, "Browned out at 1:33", listOf("It sagged."), errors = 1, warnings = 2))
        arrivalText(log("a.bag", found = found, of = match)) shouldBe
            "Qualification 78 arrived: 1 error, 2 warnings. Browned out at 1:33."
        arrivalText(log("a.bag"), others = 2) shouldBe "a.bag arrived: no errors, no warnings. 2 other logs arrived, too."
        arrivalText(log("a.bag", found = FindingSummary(0, null))) shouldBe "a.bag arrived: the rules could not be run over it."
    }
})
