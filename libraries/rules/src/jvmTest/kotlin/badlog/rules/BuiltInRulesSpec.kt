package badlog.rules

import badlog.core.analysis.LogView
import badlog.signals.pose.PLAN_LIMIT
import badlog.signals.pose.PLAN_PATIENCE
import io.kotest.assertions.withClue
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.collections.shouldNotBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldNotBeEmpty

private const val LINKS = "[[linked]]\nmotors = [\"Drive/Left\", \"Drive/Right\"]\n"

/** Each rule, and what to plant in a match so that the rule finds it. */
private val FAULTS: Map<String, TestMatch.() -> Unit> = mapOf(
    "Browned out" to { flag("/SystemStats/BrownedOut") { it in 20.0..20.3 } },
    "Low battery" to { from(20.0, BATTERY) { if (it < 20.5) "6.4" else "12" } },
    "Weak battery" to { from(20.0, BATTERY) { if (it < 21.0) "8.4" else "12" } },
    "Tired battery" to { number(BATTERY) { 10.8 - 0.015 * TestMatch.load(it) } },
    "Voltage lost without load" to { from(3.0, BATTERY) { if (it < 3.06) "9.5" else (12.6 - 0.015 * TestMatch.load(it)).toString() } },
    "Bad battery contact" to { from(20.4, BATTERY) { if (it < 20.5) "8" else (12.6 - 0.015 * TestMatch.load(it)).toString() } },
    "High battery resistance" to { number(BATTERY) { 12.8 - 0.045 * TestMatch.load(it) } },
    "Raised battery resistance" to { number(BATTERY) { 12.8 - 0.03 * TestMatch.load(it) } },
    "Current too long" to { from(20.0, CHANNEL) { if (it < 22.5) "70" else "3" } },
    "High current" to { from(20.0, CHANNEL) { if (it < 21.5) "55" else "3" } },
    "Main breaker" to { from(20.0, CHANNEL) { if (it < 22.5) "250" else "3" } },
    "High total current" to { from(20.0, CHANNEL) { if (it < 25.5) "190" else "3" } },
    "Heavy load" to { from(20.0, CHANNEL) { if (it < 21) "210" else "3" } },
    "Rail fault" to { number("/SystemStats/3v3Rail/CurrentFaults") { if (it < 20) 2.0 else 3.0 } },
    "Motor too hot" to { number("Drive/Left/TempCelsius") { 60 + it } },
    "Motor hot" to { number("Drive/Left/TempCelsius") { 45 + it } },
    "Motor stalled" to {
        from(20.0, "Drive/Left/VelocityRadPerSec") { "0" }
        from(20.0, "Drive/Left/DutyCycle") { "0.5" }
        from(20.0, "Drive/Left/SupplyCurrentAmps") { "45" }
    },
    "Output saturated" to { from(20.0, "Elevator/Output") { "1.0" } },
    "Output lost" to { from(20.0, "Drive/Left/AppliedVolts") { "0" } },
    "Motor fault" to { flag("Drive/Left/StickyFault_BootDuringEnable") { it > 20 } },
    "Device lost" to { flag("Drive/Left/Connected") { it in 0.5..20.0 } },
    "Linked motor off" to { from(20.0, "Drive/Right/SupplyCurrentAmps") { "0" } },
    "Linked motors unequal" to { number("Drive/Right/SupplyCurrentAmps") { TestMatch.load(it) / 12 } },
    "Linked speeds differ" to { from(20.0, "Drive/Right/VelocityRadPerSec") { (30 * TestMatch.output(it)).toString() } },
    "Encoder stopped" to {
        from(20.0, "Drive/Left/PositionRad") { "10" }
        from(20.0, "Drive/Left/DutyCycle") { "0.5" }
        from(20.0, "Drive/Left/SupplyCurrentAmps") { "8" }
    },
    "Motor stuck" to {
        from(20.0, "Drive/Left/VelocityRadPerSec") { "0" }
        from(20.0, "Drive/Left/DutyCycle") { "0.5" }
        from(20.0, "Drive/Left/SupplyCurrentAmps") { "25" }
    },
    "Values frozen" to { from(20.0, "Drive/Left/PositionRad") { if (it < 20.5) "10" else TestMatch.position(it).toString() } },
    "Setpoint missed" to { from(24.0, "Elevator/Height") { "0.8" } },
    "Encoders disagree" to { from(20.0, "Drive/Right/PositionRad") { "10" } },
    "Pose jumped" to { from(20.0, "Odometry/Robot/translation/x") { (6 + TestMatch.wave(it / 10)).toString() } },
    "Left the plan" to { from(10.0, "Odometry/TrajectorySetpoint/translation/x") { (5 + TestMatch.wave(it / 10) + (it - 10) / 2).toString() } },
    "Gyro drifts" to {
        flag("/DriverStation/Enabled") { it in 15.0..38.0 }
        number("Gyro/Angle") { if (it < 15) 10 + 0.4 * it else 16 + 20 * TestMatch.wave(it - 15) }
    },
    "Camera silent" to { from(20.0, "limelight/hb") { "1000" } },
    "Loop blocked" to { from(20.0, LOOP) { if (it < 20.05) "240" else "9" } },
    "Vision blocked the loop" to {
        from(20.0, LOOP) { if (it < 20.05) "240" else "9" }
        from(20.0, "Vision/Latency") { if (it < 20.1) "220" else "30" }
    },
    "Loop overrun" to { from(20.0, LOOP) { if (it < 20.05) "60" else "9" } },
    "Slow loops" to { from(20.0, LOOP) { if (it < 24) "30" else "9" } },
    "Long garbage collection" to { from(20.0, "/RealOutputs/LoggedRobot/GCTimeMS") { if (it < 20.05) "70" else "0" } },
    "Frequent garbage collection" to { from(20.0, "/RealOutputs/LoggedRobot/GCTimeMS") { if (it.toInt() % 2 == 0) "25" else "0" } },
    "CPU busy" to { from(20.0, "/DSLog/CPUUtilization") { "0.97" } },
    "CPU hot" to { from(20.0, "/SystemStats/CPUTempCelsius") { "78" } },
    "Memory nearly full" to { number("System/Free Memory MB") { 60 - 1.4 * it } },
    "Disk nearly full" to { number("System/Free Disk MB") { 60 - it } },
    "CAN bus full" to { from(20.0, "/SystemStats/CANBus/Utilization") { "0.97" } },
    "CAN utilization high" to { from(20.0, "/SystemStats/CANBus/Utilization") { "0.8" } },
    "CAN bus off" to { number("/SystemStats/CANBus/OffCount") { if (it < 20) 0.0 else 1.0 } },
    "CAN errors" to { number("/SystemStats/CANBus/ReceiveErrorCount") { if (it < 20) 0.0 else 12.0 } },
    "Link lost" to {
        flag("/DriverStation/DSAttached") { it > 1 && it !in 20.0..22.0 }
        flag("/DriverStation/Enabled") { it in TestMatch.ENABLED && it !in 20.0..22.0 }
    },
    "Link lost while disabled" to { flag("/DriverStation/DSAttached") { it > 1 && it !in 2.5..3.0 } },
    "Packets very late" to { from(20.0, "/DSLog/TripTimeMS") { "150" } },
    "Packets late" to { from(20.0, "/DSLog/TripTimeMS") { "60" } },
    "Many packets lost" to { from(20.0, "/DSLog/PacketLoss") { "0.3" } },
    "Packets lost" to { from(20.0, "/DSLog/PacketLoss") { "0.05" } },
    "Very weak radio signal" to { from(20.0, "/DSLog/WifiDb") { "-75" } },
    "Weak radio signal" to { from(20.0, "/DSLog/WifiDb") { "-65" } },
    "Late pictures" to { from(20.0, "Vision/Latency") { "180" } },
    "Low air pressure" to { from(20.0, "Pneumatics/Pressure") { "50" } },
    "Compressor always on" to { flag("Pneumatics/Compressor On") { true } },
    "Controller unplugged" to { from(20.0, "DS:joystick0/axes[0]") { "" } },
    "Button held while disabled" to {
        flag("/DriverStation/Enabled") { it in 10.0..38.0 }
        flag("DS:joystick0/buttons[0]") { it < 12 }
    },
    "Stick off center while disabled" to {
        flag("/DriverStation/Enabled") { it in 10.0..38.0 }
        number("DS:joystick0/axes[0]") { 0.3 + 0.01 * TestMatch.wave(it) }
    },
    "Restarted in the match" to {
        flag("/DriverStation/Enabled") { it < 38 }
        number("/DriverStation/MatchTime") { 90 - it }
    },
    "Ended in the match" to { flag("/DriverStation/Enabled") { it > 4 } },
    "Error logged" to { event("messages", 20.0 to "ERROR: arm encoder") },
    "Sensor lost" to { from(20.0, "Drive/Left/PositionRad") { "" } },
    "Flat sensor" to { number("Gyro/Angle") { 180.0 } },
)

private const val BATTERY = "/SystemStats/BatteryVoltage"
private const val CHANNEL = "/PowerDistribution/ChannelCurrent[2]"
private const val LOOP = "/RealOutputs/LoggedRobot/FullCycleMS"

/** Rules about the clock, which faults in cells cannot change. */
private val OF_CLOCK = listOf("Gap in time", "Clock set back")

private val OF_WHOLE_LOGS = listOf("Restarted in the match", "Ended in the match")

class BuiltInRulesSpec : FunSpec({
    val rules = RuleSet.BUILT_IN.with(RuleSet.BUILT_IN.signals.with(SignalsFile.parse(LINKS)))

    test("a healthy match has no finding") {
        TestMatch().findings(rules).map { "${it.rule}: ${it.text}" }.shouldBeEmpty()
    }

    test("each rule has a fault here, a group, a reason and a sentence about what to look at next") {
        (FAULTS.keys + OF_CLOCK) shouldContainExactlyInAnyOrder rules.rules.map { it.name }
        for (rule in RulesReader(resource(RulesFile.NAME), rules.signals, isBuiltIn = true).read().rules.rules) {
            withClue(rule.name) {
                rule.group.shouldNotBeEmpty()
                rule.reason.shouldNotBeEmpty()
                rule.next.shouldNotBeEmpty()
            }
        }
    }

    for ((rule, plant) in FAULTS) {
        test("“$rule” is found where it was planted, with its evidence") {
            val match = TestMatch().apply(plant)
            val view = match.view()
            val result = rules.over(view, "test.bag")
            result.skipped.filter { it.rule == rule }.map { it.toString() }.shouldBeEmpty()
            result.findings.map { it.rule } shouldContain rule
            val finding = result.findings.first { it.rule == rule }
            finding.next.shouldNotBeEmpty()
            finding.evidence.shouldNotBeEmpty()
            (finding.evidence - view.recording.topics.map { it.name }.toSet()).shouldBeEmpty()
        }
    }

    test("leaving the plan has the same limits on a path as in the rule") {
        rules.rules.first { it.name == "Left the plan" }.condition shouldBe "plan distance > $PLAN_LIMIT for $PLAN_PATIENCE s"
    }

    test("the finding for leaving the plan names the topics of both poses, and the distance") {
        val match = TestMatch().apply(FAULTS.getValue("Left the plan"))
        val finding = match.findings(rules).single { it.rule == "Left the plan" }
        finding.text shouldBe "The robot left its plan at 11 s, by up to 2.5 m."
        finding.evidence shouldBe listOf("Robot", "TrajectorySetpoint").flatMap { name -> listOf("x", "y").map { "Odometry/$name/translation/$it" } }
        // In teleop, the robot follows no plan.
        val byHand = TestMatch().apply { from(15.1, "Odometry/TrajectorySetpoint/translation/x") { ((it - 15) / 2).toString() } }
        byHand.findings(rules).map { it.rule }.shouldBeEmpty()
        rules.over(TestMatch().apply { without("Odometry/TrajectorySetpoint/translation/x") }.view(), "test.bag").skipped
            .single { it.rule == "Left the plan" }.message shouldBe "no topics for the robot's pose and its planned pose"
    }

    test("a part that was cut out of a log neither restarted nor ended in the match") {
        val match = TestMatch().apply { flag("/DriverStation/Enabled") { true } }
        val whole = rules.over(match.view(), "test.bag")
        whole.findings.map { it.rule }.filter { it in OF_WHOLE_LOGS } shouldBe OF_WHOLE_LOGS
        val recording = match.view().recording
        val part = rules.over(LogView.of(recording.copy(values = recording.values.ofPart("90 s to 130 s"))), "test.bag")
        part.findings.map { it.rule }.filter { it in OF_WHOLE_LOGS }.shouldBeEmpty()
        part.skipped.filter { it.rule in OF_WHOLE_LOGS }.map { it.message }.toSet() shouldBe
            setOf("the log is only part of a log (see its value “Part”)")
    }

    test("a stop of the log is found, but not while the program starts, nor while the robot is disabled") {
        fun gaps(from: Double, to: Double) = rules.over(TestMatch().view { time -> time.takeIf { it !in from..to } }, "test.bag").findings.filter { it.rule == "Gap in time" }
        gaps(20.0, 21.0).map { it.text } shouldBe listOf("Nothing was logged for up to 1.04 s (1×).")
        gaps(0.1, 1.0).shouldBeEmpty()
        gaps(2.5, 3.5).shouldBeEmpty()
    }

    test("a clock that was set back is found") {
        val view = TestMatch().view { if (it < 20) it else it - 10 }
        rules.over(view, "test.bag").findings.map { it.rule } shouldContain "Clock set back"
    }

    test("each text of an error is reported, however often others occur") {
        val match = TestMatch()
        val errors = (0..4).map { 20.0 + it to "ERROR: brownout" }
        match.event("messages", 10.0 to "WARN: CAN timeout; Elevator (ID 5)", *errors.toTypedArray())
        match.findings(rules).map { it.text } shouldContainExactlyInAnyOrder listOf(
            "messages at 10 s (1×): WARN: CAN timeout; Elevator (ID 5)",
            "messages at 20 s (5×): ERROR: brownout",
        )
    }

    test("topics that do not fit are no findings and no problems") {
        val match = TestMatch()
        for (name in listOf(BATTERY, LOOP, "/SystemStats/CANBus/Utilization", "/SystemStats/BrownedOut")) {
            match.without(name)
            match.event(name, 1.0 to "a", 2.0 to "b")
        }
        val result = rules.over(match.view(), "test.bag")
        result.findings.map { it.rule }.shouldBeEmpty()
        result.skipped.filter { it.isMistake }.shouldBeEmpty()
    }
})
