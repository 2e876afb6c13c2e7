package badlog.catalog.folder

import badlog.core.recording.Severity
import badlog.core.recording.Topic
import badlog.core.recording.Value
import badlog.files.LogFile
import badlog.rules.RulesFile
import badlog.signals.match.MatchOfLog
import badlog.viewer.catalog.Content
import badlog.viewer.catalog.FoundRule
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.nulls.shouldBeNull
import io.kotest.matchers.nulls.shouldNotBeNull
import io.kotest.matchers.shouldBe
import io.kotest.matchers.shouldNotBe
import java.nio.file.Files
import java.nio.file.Path
import java.util.concurrent.CancellationException

class LogReadingSpec : FunSpec({
    val folder = tempdir().toPath()

    fun reading(of: Path = folder) = LogReading(FolderStore(of, cache = null, "1"))

    fun read(file: Path) = reading().read(LogFile(file, Files.size(file), 0), runsRules = false)

    fun summaryOf(file: Path) = read(file).summary

    fun contentOf(text: String, name: String = "a.bag") = summaryOf(folder.put(name, text)).content

    test("a table that badlog saved among the logs is not a log") {
        contentOf("Log,Date,File,A Max (V)\r\nQualification 42,2024-03-16,/logs/q42.bag,12.5\r\n", "statistics.csv") shouldBe Content.NO_LOG
        contentOf("Match,File,min(battery) (V)\r\nQualification 42,/logs/q42.bag,7.1\r\n", "table.csv") shouldBe Content.NO_LOG
    }

    test("the samples are summarized") {
        folder.putSamples()
        val match = summaryOf(folder.resolve("qualification-42.bag"))
        match.match.match shouldBe "Qualification 42"
        match.match shouldBe MatchOfLog("Mill Creek Regional", "Qualification", "42", "Blue")
        match.batteryMinimum!! shouldBe (6.7 plusOrMinus 0.1)
        match.duration!! shouldBe (156.0 plusOrMinus 4.0)
        match.content shouldBe Content.SOMETHING
        match.topic("System/Battery Voltage")!!.statistics.min shouldBe match.batteryMinimum
        summaryOf(folder.resolve("qualification-57.bag.gz")).problems.errors shouldBe 2
        summaryOf(folder.resolve("practice.bag")).content shouldBe Content.SOMETHING
        summaryOf(folder.resolve("elevator-bench.csv")).content shouldBe Content.SOMETHING
    }

    test("a log counts as empty only without samples, changes, enough time or an enabled robot") {
        contentOf(bag(rows = 0)) shouldBe Content.NO_SAMPLES
        contentOf("") shouldBe Content.NO_SAMPLES
        contentOf(bag(voltage = { 12.0 })) shouldBe Content.NOTHING_CHANGES
        contentOf(bag(rows = 1)) shouldBe Content.NOTHING_CHANGES
        contentOf(bag(rows = 40)) shouldBe Content.TOO_SHORT
        contentOf(bag(isEnabled = false)) shouldBe Content.NEVER_ENABLED
        contentOf(bag(isEnabled = false, values = matchValues(3))) shouldBe Content.SOMETHING
        contentOf(bag()) shouldBe Content.SOMETHING
    }

    test("a WPILOG is summarized as a bag is") {
        val times = List(200) { it * 0.5 }
        val voltage = loggedTopic("NT:/SmartDashboard/BatteryVoltage", *times.map { it to 12.5 - it / 20 }.toTypedArray())
        val values = listOf(Value("Event Name", "OHCL"), Value("Match Number", "7"), Value("Match Type", "Qualification"))
        val file = folder.resolve("FRC_TBD.wpilog")
        Files.write(file, wpilogOf(listOf(voltage, loggedTopic("Gain", 0.0 to 1.0, 120.0 to 2.0)), values))
        val entry = summaryOf(file)
        entry.content shouldBe Content.SOMETHING
        entry.match shouldBe MatchOfLog("OHCL", "Qualification", "7")
        entry.duration!! shouldBe (120.0 plusOrMinus 1e-6)
        entry.xUnit shouldBe "s"
        entry.samples shouldBe 202
        entry.batteryMinimum!! shouldBe (12.5 - 99.5 / 20 plusOrMinus 1e-9)
        entry.topic("Gain")!!.preview.has(20) shouldBe true
    }

    test("a WPILOG in which nothing is logged or nothing changes is gray") {
        fun contentOf(vararg topics: Topic) = summaryOf(folder.resolve("empty.wpilog").also { Files.write(it, wpilogOf(topics.toList())) }).content
        contentOf(loggedTopic("Gain")) shouldBe Content.NO_SAMPLES
        contentOf(loggedTopic("Gain", 0.0 to 1.0, 9.0 to 1.0)) shouldBe Content.NOTHING_CHANGES
        contentOf(loggedTopic("Gain", 0.0 to 1.0, 0.5 to 2.0)) shouldBe Content.TOO_SHORT
        contentOf(loggedTexts("mode", 0.0 to "auto", 9.0 to "teleop")) shouldBe Content.SOMETHING
    }

    test("a large WPILOG is a log, whatever its name") {
        val file = folder.resolve("large.csv")
        Files.write(file, wpilogOf(listOf(loggedTopic("Gain", 0.0 to 1.0, 9.0 to 2.0))).copyOf(17 shl 20))
        isLikelyLog(LogFile(file, Files.size(file), 0)) shouldBe true
    }

    test("a file that is not a log is only listed if its name looks like a log's") {
        contentOf("Dear diary\ntoday I was happy\n", "b.csv") shouldBe Content.NO_LOG
        val entry = summaryOf(folder.put("c.bag", "Dear diary\ntoday I was happy\n"))
        entry.content shouldBe Content.UNREADABLE
        entry.trouble.shouldNotBeNull()
    }

    test("a large file that does not begin like a log is not read to its end") {
        val file = folder.put("large.csv", "Dear diary\n".repeat(2_000_000))
        var isRead = false
        reading().read(LogFile(file, Files.size(file), 0), runsRules = true, { isRead = true }).summary.content shouldBe Content.NO_LOG
        isRead shouldBe false
    }

    test("a deleted file becomes an entry with a sentence") {
        reading().read(LogFile(folder.resolve("gone.bag"), 10, 0), runsRules = true).summary.trouble.shouldNotBeNull()
    }

    test("a battery's first 0, before it was measured, is not its minimum") {
        summaryOf(folder.put("d.bag", bag(voltage = { if (it == 0) 0.0 else 12.0 - it * 0.01 }))).batteryMinimum!! shouldBe
            (10.01 plusOrMinus 1e-9)
        summaryOf(folder.put("e.csv", "Time,Speed\n0,1\n2,3\n")).batteryMinimum.shouldBeNull()
    }

    test("the rules of its folder find a match with a brownout, the worst finding first") {
        val folder = tempdir().toPath()
        folder.putSamples()
        val match = folder.resolve("qualification-42.bag")
        val file = LogFile(match, Files.size(match), 0)
        val found = reading(folder).found(file)
        found.rules.shouldNotBeNull() shouldContain FoundRule("Browned out", Severity.ERROR)
        found.worst shouldBe Severity.ERROR
        val severities = found.rules.orEmpty().map { it.severity }
        severities shouldBe severities.sortedDescending()
        found.key shouldBe FolderStore(folder, cache = null, "1").keyOf(match)

        Files.writeString(folder.resolve(RulesFile.NAME), "[[rule]]\nname = \"Moved\"\nseverity = \"note\"\nwhen = \"Arm/Angle > -1e9\"\ntext = \"t\"\n")
        val own = reading(folder).found(file)
        own.rules shouldBe listOf(FoundRule("Moved", Severity.NOTE))
        own.key shouldNotBe found.key
    }

    test("an unreadable file has unknown findings, and cancelling is passed on") {
        val folder = tempdir().toPath()
        reading(folder).found(LogFile(folder.resolve("gone.bag"), 10, 0)).rules.shouldBeNull()
        val log = folder.put("a.bag", bag())
        shouldThrow<CancellationException> { reading(folder).found(LogFile(log, Files.size(log), 0)) { throw CancellationException() } }
    }

    test("the summary is reported before the rules run, and rules skip an empty log") {
        val reported = ArrayList<LogEntry>()
        val file = folder.put("reported.bag", bag(voltage = { 6.0 + it * 0.001 }))
        val entry = reading().read(LogFile(file, Files.size(file), 0), runsRules = true) { reported += it }
        reported.single() shouldBe entry.copy(found = null)
        entry.found.shouldNotBeNull()
        val idle = folder.put("idle.bag", bag(voltage = { 12.0 }))
        reading().read(LogFile(idle, Files.size(idle), 0), runsRules = true).found.shouldBeNull()
    }
})
