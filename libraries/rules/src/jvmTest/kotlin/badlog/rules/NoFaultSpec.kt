package badlog.rules

import io.kotest.core.spec.style.FunSpec
import io.kotest.inspectors.forNone
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain

private const val POSE_X = "Odometry/Robot/translation/x"

/** Harmless things in real logs. Each was once taken for a fault. */
class NoFaultSpec : FunSpec({
    fun TestMatch.rules() = findings().map { it.rule }

    test("in an array with a changing length, the last elements are not lost sensors, and unused ones not flat ones") {
        val match = TestMatch().apply {
            for (i in 0..5) cells("Drive/OdometryDrivePositionsRad[$i]") { if (i < 4 + (it * 50).toInt() % 3) "${it + i}" else "" }
            for (i in 0..3) cells("Auto/CurrentPathPoints[$i]") { if (it in 5.0..9.0) "1.5" else "" }
        }
        match.findings().filter { "[" in it.topic.orEmpty() }.shouldBeEmpty()
    }

    test("elements of a queue that was exported one by one are not sensors; elements of an array with a constant length are") {
        fun flat(length: (Double) -> Double) = TestMatch().apply {
            number("Gyro/OdometryYawPositions/length", at = length)
            for (i in 0..3) number("Gyro/OdometryYawPositions/$i/value") { if (i < 2) TestMatch.position(it) else 1.5 }
            for (i in 0..3) number("Gyro/OdometryPositionsRad/$i") { if (i < 2) TestMatch.position(it) else 1.5 }
            number("Gyro/OdometryPositionsRad/length", at = length)
        }.findings().count { it.rule == "Flat sensor" }
        flat { 2.0 + (it * 50).toInt() % 3 } shouldBe 0
        flat { 4.0 } shouldBe 4
    }

    test("the size of an undecoded record is not measured by a sensor") {
        TestMatch().apply { number("Drive/ModulePositions", "B") { 64.0 } }.rules().forNone { it shouldContain "Flat" }
    }

    test("a sensor that rests while the robot is disabled is not flat, nor is one of a robot that is enabled for a moment") {
        fun flat(enabled: ClosedRange<Double>) = TestMatch().apply {
            flag("/DriverStation/Enabled") { it in enabled }
            number("Arm/Angle") { 12.5 }
            number("Climber/Position") { 0.0 }
        }.rules().count { it == "Flat sensor" }
        flat(50.0..60.0) shouldBe 0
        flat(20.0..26.0) shouldBe 0
        flat(20.0..35.0) shouldBe 1
    }

    test("an element that has no value while its array has one length is a lost sensor") {
        TestMatch().apply { cells("Arm/position") { if (it < 20) "$it" else "" } }.rules().count { it == "Sensor lost" } shouldBe 1
    }

    test("a pose that is reset in the second after the robot is enabled has not jumped; later it has") {
        for ((at, isFound) in listOf(4.0 to false, 4.9 to false, 15.0 to false, 15.8 to false, 20.0 to true)) {
            val jumped = TestMatch().apply { from(at, POSE_X) { "11" } }.rules()
            ("Pose jumped" in jumped) shouldBe isFound
        }
    }

    test("a heading that a driver sets to 0 has not jumped; one that jumps elsewhere has") {
        for ((heading, isFound) in listOf(0.0 to false, 180.4 to false, 47.0 to true)) {
            val match = TestMatch().apply {
                number("Gyro/Angle") { 90 + 0.01 * TestMatch.wave(it * 40) }
                from(20.0, "Gyro/Angle") { (heading + 0.01 * TestMatch.wave(it * 40)).toString() }
            }
            ("Heading jumped" in match.rules()) shouldBe isFound
        }
    }

    test("a robot that turns has no ratio between its sides, and a side that stands still is found nevertheless") {
        fun match(own: TestMatch.() -> Unit) = TestMatch().apply {
            number("Drive/Right/PositionRad") { TestMatch.position(it) + 40 * TestMatch.wave(it / 3) }
            own()
        }
        match {}.rules().forNone { it shouldContain "still" }
        match { from(20.0, "Drive/Left/PositionRad") { "10" } }.rules().count { it == "Side stands still" } shouldBe 1
    }

    test("an array that is empty while the robot is disabled has lost no sensor") {
        TestMatch().apply {
            for (i in 0..3) cells("SwerveStates/Setpoints[$i]/angle") { if (it in 4.0..20.0) "$it" else "" }
        }.rules().forNone { it shouldContain "Sensor" }
    }

    test("one of several sensors with gaps counts as lost if the others have none") {
        val match = TestMatch().apply {
            for (i in 0..3) cells("Swerve/Module[$i]/Angle") { if (i == 1 && (it in 20.0..22.0 || it in 25.0..27.0)) "" else "$it" }
        }
        match.findings().filter { it.rule == "Sensor lost" }.map { it.topic } shouldBe listOf("Swerve/Module[1]/Angle")
    }

    test("the first loops after the robot is enabled are slow") {
        TestMatch().apply { within(4.1..4.4, LOOP_TIME) { "250" } }.rules().forNone { it shouldContain "Loop" }
    }

    test("values from memory that was never written are not currents") {
        val match = TestMatch().apply {
            for (i in 0..3) number("/PowerDistribution/ChannelCurrent[$i]") { if (it.toInt() % 2 == 0) 1.9e276 else 6.95e-310 }
        }
        match.rules().forNone { it shouldContain "urrent" }
    }

    test("a temperature that jumps is misread") {
        TestMatch().apply { from(20.0, "Drive/Left/TempCelsius") { if (it < 30) "144" else "45" } }.rules().forNone { it shouldContain "hot" }
        TestMatch().apply {
            number("Drive/Left/TempCelsius") {
                if (it < 20) {
                    1.0
                } else if (it < 30) {
                    216.0
                } else {
                    109.0
                }
            }
        }.rules().forNone { it shouldContain "hot" }
    }

    test("an elevator that is held up by its motor is not jammed; an intake that does not turn is") {
        fun jammed(part: String) = TestMatch().apply {
            number("$part/VelocityRadPerSec") { if (it in 20.0..25.0) 0.0 else 50 * TestMatch.output(it) }
            number("$part/AppliedVolts") { if (it in 20.0..25.0) 10.0 else 12 * TestMatch.output(it) }
            number("$part/CurrentAmps") { if (it in 20.0..25.0) 40.0 else 10.0 }
        }.findings().any { it.rule == "Driven without moving" && part in it.text }
        jammed("Climber") shouldBe false
        jammed("Intake") shouldBe true
    }

    test("an encoder that was never read is not one that stopped") {
        TestMatch().apply {
            number("Wrist/Motor Position") { 20 * TestMatch.wave(it) }
            number("Wrist/Encoder Position") { 0.0 }
        }.rules().forNone { it shouldContain "Encoder" }
    }

    test("a controller that is unplugged is one finding, not one for each axis") {
        val match = TestMatch().apply {
            for (axis in 0..5) cells("DS:joystick0/axes[$axis]") { if (it in 20.0..25.0) "" else "0.01" }
        }
        match.findings().filter { it.rule == "Controller unplugged" }.map { it.topic } shouldBe listOf("DS:joystick0/axes[0]")
    }

    test("a log that begins in teleop while the program had run for minutes was only begun late") {
        fun begins(at: Double) = TestMatch().apply(PLANTED.getValue("Log begins in teleop")).view { it + at }.let { HEARD_RULES.over(it, "test.bag") }
            .findings.count { it.rule == "Log begins in teleop" }
        begins(at = 12.0) shouldBe 1
        begins(at = 112.0) shouldBe 0
    }

    test("axes that vanish one after the other are still one controller; a controller that is unplugged later is another finding") {
        fun gone(vararg from: Double) = TestMatch().apply {
            for ((axis, start) in from.withIndex()) cells("DS:joystick0/axes[$axis]") { if (it in start..start + 5) "" else "0.01" }
        }.findings().count { it.rule == "Controller unplugged" }
        gone(20.0, 20.1, 20.3, 20.04) shouldBe 1
        gone(20.0, 20.1, 28.0) shouldBe 2
    }

    test("two controllers that are unplugged one after the other are two findings") {
        TestMatch().apply {
            for ((controller, from) in listOf(20.0, 20.6).withIndex()) {
                for (axis in 0..1) cells("DS:joystick$controller/axes[$axis]") { if (it in from..from + 5) "" else "0.01" }
            }
        }.findings().filter { it.rule == "Controller unplugged" }.map { it.topic } shouldBe listOf("DS:joystick0/axes[0]", "DS:joystick1/axes[0]")
    }

    test("a gyro that counts the other way or in rad, or leaves the camera in a curve, and the heading of a goal, show no drift") {
        fun leaves(pose: String = "Vision/Pose", gyro: (Double) -> Double) = TestMatch().apply {
            number("$pose[0]") { 5.0 }
            number("$pose[1]") { 3.0 }
            number("$pose[2]") { 6 * it }
            number("Gyro/Angle", at = gyro)
        }.findings().count { it.rule == "Heading leaves the camera" }
        leaves { 6.6 * it } shouldBe 1
        leaves { -6 * it } shouldBe 0
        leaves { Math.toRadians(6 * it) } shouldBe 0
        leaves { 6.6 * it + 2.6 * TestMatch.wave(0.15 * it) } shouldBe 0
        leaves("Vision/Goal") { 6.6 * it } shouldBe 0
    }

    test("a limit that is open where its name says that it is reached, a limit at the other end, and a climber's, stop nothing") {
        fun stops(part: String, limit: String, until: Double = 24.0, isReached: (Double) -> Boolean = { it in 17.0..24.0 }) = TestMatch().apply {
            number("$part/Setpoint") { TestMatch.setpoint(it) }
            number("$part/Height") { minOf(TestMatch.height(it), if (it < until) 0.85 else 1.1) }
            flag("$part/$limit", isReached)
        }.findings().count { it.rule == "Stopped by a limit" }
        stops("Lift", "Upper Limit") shouldBe 1
        stops("Lift", "Upper Limit", until = 20.0) { minOf(TestMatch.height(it), if (it < 20) 0.85 else 1.1) < 0.95 } shouldBe 0
        stops("Upper Arm", "Lower Limit") shouldBe 0
        stops("Climber", "Upper Limit") shouldBe 0
    }

    test("a steering motor that counts turns does not overshoot the angle that its wheel should have") {
        fun overshoots(part: String) = TestMatch().apply {
            number("$part Angle (deg)") { 90 * (TestMatch.height(it) + if (it % 8 in 0.5..1.2) 0.25 * step(it) else 0.0) }
            number("$part Setpoint (deg)") { 90 * TestMatch.setpoint(it) }
        }.findings().any { it.rule == "Overshoot" && part in it.text }
        overshoots("Wrist") shouldBe true
        overshoots("Front Left Turn") shouldBe false
        overshoots("fl_turn") shouldBe false
        overshoots("Front Left") shouldBe false
    }

    test("an encoder of a steering motor that stops is found") {
        TestMatch().apply {
            number("fl_turn Angle (deg)") { if (it < 18.5) 90 * TestMatch.wave(it * 0.75) else -270.0 }
            number("fl_turn Setpoint (deg)") { 90 * TestMatch.wave(it * 0.75) }
        }.findings().filter { it.rule == "Encoder frozen" }.map { it.topic } shouldBe listOf("fl_turn Angle (deg)")
    }

    test("of a loop's messages on the console, the line with the error is quoted") {
        val match = TestMatch().apply {
            event("messages", 20.0 to "********** Robot program starting **********\\nError at frc.Lights: no Arduino\\n\\tat java.Lang")
        }
        match.findings().single { it.rule == "Error logged" }.text shouldContain "Error at frc.Lights: no Arduino"
    }
})
