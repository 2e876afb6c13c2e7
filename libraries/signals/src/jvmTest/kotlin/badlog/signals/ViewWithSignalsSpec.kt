package badlog.signals

import badlog.core.analysis.EnabledSpan
import badlog.core.analysis.LogView
import badlog.core.analysis.Span
import badlog.core.analysis.enabledSpans
import badlog.core.analysis.knowsEnabled
import badlog.core.bag.BagParser
import badlog.core.json.quotedJson
import badlog.expression.Expression
import badlog.expression.ExpressionError
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import badlog.rules.RulesFile
import badlog.rules.over
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.types.shouldBeInstanceOf

/** A log of these topics, a row a second. */
private fun logOf(vararg topics: Pair<String, List<String>>, values: Map<String, String> = emptyMap()): LogView {
    val names = listOf("Time") + topics.map { it.first }
    val described = names.joinToString(",") { name ->
        """{"name":${quotedJson(name)},"unit":"${if (name == "Time") "s" else "ul"}","attrs":[${if (name == "Time") "\"xaxis\"" else ""}]}"""
    }
    val given = values.entries.joinToString(",") { (name, value) -> """{"name":"$name","value":"$value"}""" }
    val rows = List(topics.maxOf { it.second.size }) { row -> (listOf("$row") + topics.map { it.second[row] }).joinToString(",") }
    val text = (listOf("""{"topics":[$described],"values":[$given]}""", names.joinToString(",")) + rows).joinToString("\n", postfix = "\n")
    return LogView.of(BagParser().apply { accept(text.encodeToByteArray()) }.finish())
}

private val OFF_ON = listOf("false", "true", "true", "true", "false")
private val ON_OFF = listOf("true", "false", "false", "false", "true")
private val ALONE = listOf("true", "true", "false", "false", "false")

class ViewWithSignalsSpec : FunSpec({
    val vocabulary = RuleSet.BUILT_IN.signals

    val kinds = mapOf(
        "WPILib" to arrayOf("/Shooter/enabled" to ON_OFF, "DS:enabled" to OFF_ON, "DS:autonomous" to ALONE),
        "the control word of NetworkTables" to
            arrayOf("/Shooter/enabled" to ON_OFF, "NT:/FMSInfo/FMSControlData" to listOf("34", "35", "33", "33", "32")),
        "AdvantageKit" to arrayOf("/DriverStation/Enabled" to OFF_ON, "/DriverStation/Autonomous" to ALONE),
        "AdvantageKit from 2027 on" to arrayOf(
            "/DriverStation/Enabled" to OFF_ON,
            "/DriverStation/RobotMode" to listOf("AUTONOMOUS", "AUTONOMOUS", "TELEOPERATED", "TELEOPERATED", "TELEOPERATED"),
        ),
        "Phoenix" to arrayOf("RobotEnable" to OFF_ON, "RobotMode" to listOf("Autonomous", "Autonomous", "Teleop", "Teleop", "Teleop")),
        "Driver Station" to arrayOf("/DSLog/Status/DSDisabled" to ON_OFF, "/DSLog/Status/RobotAuto" to listOf("false", "true", "false", "false", "false")),
        "bags" to arrayOf("System/Enabled" to OFF_ON, "System/Autonomous" to ALONE),
    )
    val word = "DS:controlWord"
    test("utility is not teleop, emergency stop, field and Driver Station are read from the control word, and op modes have names") {
        val view = logOf(
            "$word/enabled" to OFF_ON,
            "$word/robotMode" to listOf("autonomous", "autonomous", "utility", "utility", "utility"),
            "$word/eStop" to List(5) { "false" },
            "$word/fmsAttached" to List(5) { "true" },
            "$word/dsAttached" to List(5) { "true" },
            "DS:opMode" to listOf("", "Two pieces", "Zero the arm", "Zero the arm", ""),
        ).withSignals(vocabulary, "log")
        view.enabledSpans() shouldBe listOf(
            EnabledSpan(Span(1.0, 2.0), isAutonomous = true, opMode = "Two pieces"),
            EnabledSpan(Span(2.0, 4.0), isAutonomous = false, isTest = true, opMode = "Zero the arm"),
        )
        fun topicOf(signal: String) = signalTopicsOf(view, vocabulary).of(signal).single().topic
        topicOf("emergency stop") shouldBe "$word/eStop"
        topicOf("FMS attached") shouldBe "$word/fmsAttached"
        topicOf("link") shouldBe "$word/dsAttached"
    }

    for ((kind, topics) in kinds) {
        test("when the robot was enabled is right in logs of $kind") {
            val view = logOf(*topics).withSignals(vocabulary, "log")
            view.enabledSpans() shouldBe listOf(EnabledSpan(Span(1.0, 2.0), true), EnabledSpan(Span(2.0, 4.0), false))
            view.namesWith(vocabulary).enabled shouldBe view.enabledSpans()
        }
    }

    test("a mechanism that was enabled does not mean that the robot was, and an empty topic does not count") {
        val view = logOf("NT:/Robot/shooter/enabled" to OFF_ON, "DS:enabled" to List(5) { "" }).withSignals(vocabulary, "log")
        view.knowsEnabled shouldBe false
        val other = logOf("DS:enabled" to List(5) { "" }, "/DriverStation/Enabled" to OFF_ON).withSignals(vocabulary, "log")
        other.enabledSpans().map { it.span } shouldBe listOf(Span(1.0, 4.0))
    }

    test("of a topic that NetworkTables logged once, and the program logs again, the one that changes counts") {
        val once = "NT:/FMSInfo/FMSControlData" to listOf("32", "", "", "", "")
        val view = logOf(once, "/FMSInfo/FMSControlData" to listOf("32", "33", "33", "33", "32")).withSignals(vocabulary, "log")
        view.enabledSpans().map { it.span } shouldBe listOf(Span(1.0, 4.0))
        logOf(once, "/FMSInfo/FMSControlData" to listOf("33", "", "", "", "")).withSignals(vocabulary, "log").enabledSpans() shouldBe emptyList()
    }

    test("the match is from topics if no value has it, and unknown before the field sends it") {
        val number = "NT:/FMSInfo/MatchNumber" to listOf("0", "0", "42", "42", "42")
        val type = "NT:/FMSInfo/MatchType" to listOf("0", "0", "2", "2", "2")
        val event = "NT:/FMSInfo/EventName" to listOf("", "", "MILLC", "MILLC", "MILLC")
        logOf(number, type, event).withSignals(vocabulary, "log").title shouldBe "MILLC Qualification 42"
        logOf(number, type, values = mapOf("Match Number" to "7", "Match Type" to "Practice")).withSignals(vocabulary, "log").title shouldBe "Practice 7"
        logOf("a" to List(5) { "1" }).withSignals(vocabulary, "Q42.wpilog").title shouldBe "Qualification 42"
        logOf("/DriverStation/MatchNumber" to List(5) { "0" }, "a" to List(5) { "1" }).withSignals(vocabulary, "log").title shouldBe null
    }

    test("rules use the meaning of a topic, however the topic expresses it") {
        val rules = RulesFile.parse("[[rule]]\nname = \"Off\"\nseverity = \"note\"\ntext = \"Off.\"\nwhen = \"not robot enabled for 1 s\"\n").rules
        val view = logOf("/DSLog/Status/DSDisabled" to listOf("false", "true", "true", "true", "false"))
        rules.over(view, "a").findings.single().spans shouldBe listOf(Span(1.0, 4.0))
    }

    test("formulas can name signals, and a topic with the name of a signal takes precedence") {
        val volts = logOf("/SystemStats/BatteryVoltage" to listOf("12", "11", "10", "11", "12"), "PDP/Chan0" to List(5) { "3" }, "PDP/Chan1" to List(5) { "4" })
        val power = volts.withVirtualTopics(listOf("Power [W] = battery * total current", "battery = battery + 1", "Twice = battery * 2"), vocabulary)
        power.errors shouldBe emptyList()
        power.view.recording.topics.first { it.name == "Power" }.samples.toList() shouldBe listOf(84.0, 77.0, 70.0, 77.0, 84.0)
        power.view.recording.topics.first { it.name == "Twice" }.samples.toList() shouldBe listOf(26.0, 24.0, 22.0, 24.0, 26.0)
        val topic = logOf("/SystemStats/BatteryVoltage" to List(5) { "12" }, "Drive/Battery" to List(5) { "1" })
        (Expression.parse("battery < 7", topic.namesWith(vocabulary).vocabulary) as Expression).topics shouldBe listOf("Drive/Battery")
    }

    test("a signal that the log lacks is reported as such, with what to do") {
        val names = logOf("Arm/Angle" to List(5) { "1" }).namesWith(vocabulary).vocabulary
        val error = Expression.parse("min(Battery) < 7", names).shouldBeInstanceOf<ExpressionError>()
        error.message shouldContain "The log has no topic for the signal “battery”; name yours in badlog-signals.toml."
    }
})
