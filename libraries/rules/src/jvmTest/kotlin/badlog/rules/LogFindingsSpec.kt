package badlog.rules

import badlog.core.analysis.LogView
import badlog.core.bag.BagParser
import badlog.core.recording.CellCounts
import badlog.core.recording.Recording
import badlog.core.recording.TextColumn
import badlog.core.recording.Topic
import badlog.formats.wpilog.WpilogFormat
import badlog.rules.comparison.numbersOf
import badlog.signals.match.MatchKind
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.shouldBe

class LogFindingsSpec : FunSpec({
    val header = """{"topics":[{"name":"Time","unit":"s","attrs":["xaxis"]},{"name":"Battery Voltage","unit":"V","attrs":[]}],"values":[]}"""
    val bag = "$header\nTime,Battery Voltage\n0,12\n1,6\n2,6\n3,12\n"
    val view = LogView.of(BagParser().apply { accept(bag.encodeToByteArray()) }.finish())

    test("the rules run over a view that is already read, and those that do not fit it are reported") {
        val result = RuleSet.BUILT_IN.over(view, "test.bag")
        result.findings.map { it.rule } shouldContain "Low battery"
        result.skipped.map { it.rule } shouldContain "Loop overrun"
        result.skipped.none { it.isMistake } shouldBe true
    }

    test("a duration has three digits, however exact the times are") {
        val bag = "$header\nTime,Battery Voltage\n0,12\n1,6\n2.123456,6\n3.997734,12\n5,12\n"
        val rules = RulesFile.parse("[[rule]]\nname = \"A\"\nseverity = \"note\"\nwhen = \"Battery Voltage < 7\"\ntext = \"{duration}\"\n").rules
        val exact = LogView.of(BagParser().apply { accept(bag.encodeToByteArray()) }.finish())
        rules.over(exact, "a.bag").findings.single().text shouldBe "3 s"
    }

    test("every place is kept, for going from one to the next, and each has its own numbers") {
        val rows = (0 until 800).joinToString("") { "$it,${if (it % 2 == 0) "12" else "${it % 7}.5"}\n" }
        val many = LogView.of(BagParser().apply { accept("$header\nTime,Battery Voltage\n$rows".encodeToByteArray()) }.finish())
        val rule = "[[rule]]\nname = \"A\"\nseverity = \"note\"\nwhen = \"Battery Voltage < 7\"\ntext = \"{value} at {time} for {duration} ({count}×)\"\n"
        val rules = RulesFile.parse(rule).rules
        val all = rules.over(many, "a.bag", isEverywhere = true).findings.single()
        all.text shouldBe "0.5 V at 1 s for 399 s (400×)"
        all.spans.size shouldBe 400
        all.texts.take(3) shouldBe listOf("1.5 V at 1 s for 1 s", "3.5 V at 3 s for 1 s", "5.5 V at 5 s for 1 s")
        all.textAt(checkNotNull(all.placeNear(798.9))) shouldBe "1.5 V at 799 s for 0 s"
        rules.over(many, "a.bag").findings.single().run {
            spans.size shouldBe Finding.MAX_SPANS
            texts shouldBe emptyList()
            textAt(spans[5]) shouldBe all.text
        }
    }

    test("a match that only the file's name shows is the same for rules, their texts and comparisons") {
        val rule = "[[rule]]\nname = \"A\"\nseverity = \"note\"\nwhen = \"Battery Voltage < 7\"\ntext = \"{match}\"\nonly = [\"Qualification\"]\n"
        val rules = RulesFile.parse(rule).rules
        rules.over(view, "Q42.bag").findings.map { it.text } shouldBe listOf("Qualification 42")
        rules.over(view, "log.bag").findings shouldBe emptyList()
        val lacking = RulesFile.parse(rule.replace("Battery Voltage", "Arm")).rules
        lacking.skippedFor(view, "Q42.bag").map { it.rule } shouldBe listOf("A")
        lacking.skippedFor(view, "log.bag") shouldBe emptyList()
        fun kindOf(file: String) = numbersOf(view, RuleSet.BUILT_IN.signals, file).kind
        listOf("Q42.bag", "practice-3.bag", "log.bag").map(::kindOf) shouldBe listOf(MatchKind.MATCH, MatchKind.PRACTICE, MatchKind.UNKNOWN)
    }

    test("a wrong rule is reported as such, with its place") {
        val rules = RulesFile.parse("[[rule]]\nname = \"A\"\nseverity = \"note\"\nwhen = \"mean(Battery Voltage, 5) < 3\"\ntext = \"t\"\n").rules
        val skipped = rules.over(view, "test.bag").skipped.single()
        skipped.isMistake shouldBe true
        skipped.message.lines()[0].contains("4") shouldBe true
    }

    fun messages(vararg said: Pair<Double, String>) = Topic(
        "messages",
        "",
        listOf("log"),
        DoubleArray(said.size) { Double.NaN },
        TextColumn(IntArray(said.size) { it }, IntArray(said.size) { it }, said.map { it.second }),
        CellCounts(0, 0, 0, said.size, 0, 0),
        DoubleArray(said.size) { said[it].first },
    )

    fun loggedIn(said: Topic): List<String> {
        val log = Recording(WpilogFormat, null, emptyList(), listOf(said), 0, emptyList())
        return RuleSet.BUILT_IN.over(LogView.of(log), "a.wpilog", isEverywhere = true).findings.filter { it.rule == "Error logged" }
            .flatMap { found -> listOf(found.text) + found.texts }
    }

    test("of messages that share a time, or a row's cell, the finding quotes the error, not the others") {
        loggedIn(messages(1.0 to "error in robotPeriodic", 1.0 to "Shooter.periodic(): 0.9 ms", 2.0 to "ready")) shouldBe
            listOf("messages at 1 s: error in robotPeriodic")
        loggedIn(messages(1.0 to "CAN timeout; Elevator (ID 5)", 4.0 to "Arm.periodic(): 0.0003 s; ".repeat(20) + "error in teleop")) shouldBe listOf(
            "messages at 1 s: CAN timeout; Elevator (ID 5)",
            "messages at 4 s: error in teleop",
        )
    }

    test("errors that differ only in their stack traces are the same error, named by their first line") {
        loggedIn(
            messages(
                1.0 to "ERROR -200 CTR: no response from Talon FX\n\tat a.B.c(B.java:12)",
                2.0 to "ERROR -200 CTR: no response from Talon FX\n Stack Trace not received",
                3.0 to "Error:\n  java.lang.NullPointerException\n\tat frc.robot.Arm",
            ),
        ) shouldBe listOf(
            "messages at 1 s (2×): ERROR -200 CTR: no response from Talon FX",
            "messages at 1 s: ERROR -200 CTR: no response from Talon FX",
            "messages at 2 s: ERROR -200 CTR: no response from Talon FX",
            "messages at 3 s: Error:\n  java.lang.NullPointerException",
        )
    }

    fun ownTimes(name: String, vararg times: Double) = Topic(
        name,
        "",
        emptyList(),
        DoubleArray(times.size),
        TextColumn.EMPTY,
        CellCounts(times.size, 0, 0, 0, 0, 0),
        times,
    )

    fun findingsOf(topics: List<Topic>) = RuleSet.BUILT_IN.over(LogView.of(Recording(WpilogFormat, null, emptyList(), topics, 0, emptyList())), "a.wpilog")

    test("if topics have their own times, the time is every one of them, whatever topics are called") {
        val enabled = Topic("DS:enabled", "", emptyList(), doubleArrayOf(1.0, 1.0), TextColumn.EMPTY, CellCounts(2, 0, 0, 0, 0, 0), doubleArrayOf(0.0, 6.0))
        val result = findingsOf(listOf(ownTimes("A/Time", 0.0, 0.1, 2.5, 6.0), ownTimes("B/Time", 0.2, 2.9), enabled))
        result.findings.single { it.rule == "Gap in time" }.run {
            text shouldBe "Nothing was logged for up to 3.1 s while the robot was enabled."
            topic shouldBe null
            time shouldBe 6.0
        }
        result.skipped.none { it.isMistake || it.rule == "Clock set back" } shouldBe true
    }

    test("a rule that fails is skipped, and the others' findings are kept") {
        val broken = Topic("Pneumatics/Pressure", "psi", emptyList(), DoubleArray(3), TextColumn.EMPTY, CellCounts(3, 0, 0, 0, 0, 0), doubleArrayOf(0.0))
        val enabled = Topic("DS:enabled", "", emptyList(), doubleArrayOf(1.0, 1.0), TextColumn.EMPTY, CellCounts(2, 0, 0, 0, 0, 0), doubleArrayOf(0.0, 6.0))
        val result = findingsOf(listOf(ownTimes("A", 0.0, 0.1, 2.5, 6.0), enabled, broken))
        val failed = result.skipped.single { it.rule == "Low air pressure" }
        failed.isMistake shouldBe true
        failed.message.startsWith("It stopped, which is a mistake of badlog") shouldBe true
        result.findings.map { it.rule } shouldContain "Gap in time"
    }

    test("a log that counts rows has no time, whatever topics are called") {
        val csv = LogView.of(BagParser().apply { accept("A/Time,b\n0,1\n5,2\n".encodeToByteArray()) }.finish())
        RuleSet.BUILT_IN.over(csv, "a.csv").skipped.single { it.rule == "Gap in time" }.message shouldBe "the log has no x axis"
    }

    test("the run can be stopped between two rules") {
        var rules = 0
        shouldThrow<InterruptedException> {
            RuleSet.BUILT_IN.over(view, "test.bag") { if (++rules == 3) throw InterruptedException() }
        }
        rules shouldBe 3
    }
})
