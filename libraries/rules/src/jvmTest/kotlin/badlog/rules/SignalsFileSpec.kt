package badlog.rules

import badlog.expression.signals.Signal
import badlog.expression.signals.SignalKind
import badlog.expression.signals.Vocabulary
import badlog.signals.LogShape
import badlog.signals.vocabulary.SignalTopics
import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.maps.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.property.Arb
import io.kotest.property.arbitrary.filter
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll

private class Named(val topic: Signal, val signal: String?)

private fun namesOf(text: String): List<Named> = text.lines().filter { it.isNotBlank() && !it.startsWith("#") }.map { line ->
    val (name, kind, signal) = line.split(" | ")
    val unit = Regex(" \\[([^\\]]+)]$").find(name)
    val isOfUnit = unit != null && !name.endsWith("[0]")
    Named(
        Signal(if (isOfUnit) name.removeSuffix(unit.value) else name, SignalKind.valueOf(kind.uppercase()), if (isOfUnit) unit.groupValues[1] else ""),
        signal.takeIf { it != "-" },
    )
}

class SignalsFileSpec : FunSpec({
    val names = namesOf(checkNotNull(SignalsFileSpec::class.java.getResource("/signal-names.txt")).readText())
    val builtIn = RuleSet.BUILT_IN.signals

    fun topics(vararg signals: Signal) = SignalTopics(builtIn, Vocabulary(signals.toList()), null)

    test("each name that libraries use is the right signal, and misleading names are no signals") {
        val wrong = names.associate { named ->
            named.topic.name to (topics(named.topic).all.map { it.signal } to named.signal)
        }.filterValues { (found, wanted) -> if (wanted == null) found.isNotEmpty() else wanted !in found }
        wrong.shouldBeEmpty()
    }

    test("a unit comes from the log, from the vocabulary, or from the name, and the reason says which") {
        fun only(signal: Signal) = topics(signal).all.first()
        only(Signal("System/Loop Time", SignalKind.NUMBER, "s")).run { scale to reason } shouldBe (1000.0 to "fits “*loop time”, unit s in the log")
        only(Signal("/SystemStats/CANBus/Utilization", SignalKind.NUMBER)).run { scale to reason } shouldBe
            (100.0 to "fits “*CANBus/Utilization”, fraction, as such logs have it")
        only(Signal("/Robot/LoopTimeMicros", SignalKind.NUMBER)).reason shouldContain "unit us in the name"
        only(Signal("CAN Load", SignalKind.NUMBER)).run { scale to reason } shouldBe (null to "fits “*CAN load”, percent or fraction by its samples")
        topics(Signal("System/Battery Voltage", SignalKind.NUMBER, "%")).all.filter { it.signal == "battery" } shouldBe emptyList()
    }

    test("if no total is logged, it is the sum of the channels") {
        val match = TestMatch()
        val view = match.view()
        val signals = SignalTopics(builtIn, LogShape.of(view).vocabulary, "Time")
        signals.of("total current") shouldBe emptyList()
        signals.summandsOf("total current").size shouldBe 4
    }

    test("adding a topic as the first name of a signal leaves the rest of the file unchanged") {
        SignalsFile.withTopic("", "battery", "Power/My Volts") shouldBe "[[signal]]\nname = \"battery\"\ntopics = [\"Power/My Volts\"]\n"
        val text = "# ours\r\n[[signal]]\r\nname = \"battery\"\r\ntopics = [ # old\r\n  \"Volts\",\r\n]\r\n\r\n[units]\r\nTicks = \"ticks\"\r\n"
        SignalsFile.withTopic(text, "battery", "New") shouldBe text.replace("[ #", "[\"New\",  #")
        SignalsFile.withTopic("signal = [{ name = \"battery\", topics = 'Volts' }]", "battery", "New") shouldBe
            "signal = [{ name = \"battery\", topics = [\"New\", 'Volts'] }]"
        SignalsFile.parse(SignalsFile.withTopic(text, "loop time", "Loop")).signals.map { it.name } shouldBe listOf("battery", "loop time")
        shouldThrow<RulesException> { SignalsFile.withTopic("[[signal]\n", "battery", "New") }
    }

    test("any topic can be added, whatever its letters, and another one after it") {
        checkAll(Arb.string(1..30).filter { it.isNotBlank() }, Arb.string(1..30).filter { it.isNotBlank() }) { one, other ->
            val text = SignalsFile.withTopic(SignalsFile.withTopic("", "battery", one), "battery", other)
            SignalsFile.parse(text).find("battery")?.topics?.map { it.pattern.text } shouldBe listOf(other, one)
        }
    }

    test("a team's names take precedence, and can be signals of their own") {
        val own = SignalsFile.parse(
            """
            [units]
            Zaps = "V"
            [[signal]]
            name = "battery"
            topics = ["My/Zaps"]
            [[signal]]
            name = "hood angle"
            topics = [["Hood/Pos", "rad"]]
            unit = "deg"
            """.trimIndent(),
        )
        val found = SignalTopics(
            builtIn.with(own),
            Vocabulary(listOf(Signal("/SystemStats/BatteryVoltage", SignalKind.NUMBER), Signal("My/Zaps", SignalKind.NUMBER), Signal("Hood/Pos", SignalKind.NUMBER))),
            null,
        )
        found.of("battery").single().topic shouldBe "My/Zaps"
        found.of("hood angle").single().run { unit shouldBe "deg" }
        found.all.map { it.signal } shouldContain "hood angle"
    }

    val mistakes = mapOf(
        "[[signal]]\nname = \"a\"\n" to "Line 1: This signal has no “topics”.",
        "[[signal]]\nname = \"1\"\ntopics = [\"b\"]\n" to "Line 2: A signal's name begins with a letter",
        "[[signal]]\nname = \"a\"\ntopics = [1]\n" to "Line 3: “topics” is a list of names or pairs",
        "[[signal]]\nname = \"a\"\ntopics = [\"b\"]\nis = \"x\"\n" to "Line 4: A signal is a “number”, a “condition” or a “text”, not “x”.",
        "[[linked]]\nmotors = [\"b\"]\n" to "Line 2: “motors” needs at least two",
        "units = 1\n" to "Line 1: “units” must be a table",
        "[[signals]]\n" to "“signals” is not a key of the file",
    )
    for ((text, message) in mistakes) {
        test("refuses ${text.replace('\n', ' ')}") { shouldThrow<RulesException> { SignalsFile.parse(text) }.message shouldContain message }
    }

    test("devices in snake case that report whether they answer are recognized, others with such names are not") {
        fun topics(name: String) = SignalTopics(RuleSet.BUILT_IN.signals, Vocabulary(listOf(Signal(name, SignalKind.CONDITION))), null)
        for (name in listOf("arm_connected", "drive_right_2_connected")) topics(name).of("device connected").map { it.topic } shouldBe listOf(name)
        topics("robot_autonomous").of("robot autonomous").map { it.topic } shouldBe listOf("robot_autonomous")
        for (name in listOf("arm_disconnected", "radio_connected", "driver_controller_connected", "NTConnection/connected")) topics(name).of("device connected") shouldBe emptyList()
        topics("Elbow/Motor/Faults/Brownout").of("brownout") shouldBe emptyList()
    }

    test("snake case, units as suffixes and other libraries' paths are recognized") {
        val names = mapOf("can/can_rx_errors" to "CAN errors", "canStatus/receiveErrorCount" to "CAN errors", "drive/gyro_yaw_deg" to "gyro angle", "intake/velocity_mps" to "motor velocity", "arm_temp_c" to "motor temperature", "cpu_temp_c" to "CPU temperature", "match_time_s" to "match time", "Imu/RobotHeading" to "gyro angle")
        for ((name, signal) in names) {
            val topics = SignalTopics(RuleSet.BUILT_IN.signals, Vocabulary(listOf(Signal(name, SignalKind.NUMBER))), null)
            topics.of(signal).map { it.topic } shouldBe listOf(name)
        }
    }
})
