package badlog.rules

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

/** Mechanisms that are blocked, and others that only look so. */
class BlockedSpec : FunSpec({
    fun TestMatch.blocked() = findings().filter { it.rule == "Driven without moving" }.map { it.text.substringBefore(" hardly") }

    /** A lift at [height], with a motor that takes [amperes]. */
    fun lift(height: (Double) -> Double, amperes: (Double) -> Double) = TestMatch().apply {
        number("Elevator/Height", at = height)
        number("Elevator/Current Amps", at = amperes)
    }.blocked()

    /** Motors with these ids that do not turn for 13 s, at this output and current. */
    fun devices(vararg ids: Int, output: Double = 0.6, amperes: Double = 24.0, until: Double = 33.0) = TestMatch().apply {
        for (id in ids) {
            number("TalonFX-$id/DutyCycle") { if (it in 20.0..until) output else 0.3 * TestMatch.output(it) }
            number("TalonFX-$id/Velocity") { if (it in 20.0..until) 0.0 else 60 * TestMatch.output(it) }
            number("TalonFX-$id/SupplyCurrent") { if (it in 20.0..until) amperes else 3.0 }
        }
    }.blocked()

    test("a lift that does not reach its setpoint at 45 A is blocked") {
        lift({ if (it < 17) TestMatch.height(it) else 0.5 }, { if (it in 17.0..24.0) 45.0 else 6.0 }) shouldBe listOf("Elevator")
    }

    test("a lift whose topics have short names in snake case is blocked, too") {
        TestMatch().apply {
            number("lift_goal") { TestMatch.setpoint(it) }
            number("lift_pos") { if (it < 17) TestMatch.height(it) else 0.5 }
            number("lift_amps") { if (it in 17.0..24.0) 45.0 else 6.0 }
        }.blocked() shouldBe listOf("Lift")
    }

    test("a lift is judged by its goal, not by what its motor is set to") {
        TestMatch().apply {
            number("Lift/Motor Set") { 0.3 * TestMatch.output(it) }
            number("Lift/Goal") { TestMatch.setpoint(it) }
            number("Lift/Height") { if (it < 17) TestMatch.height(it) else 0.5 }
            number("Lift/Amps") { if (it in 17.0..24.0) 45.0 else 6.0 }
        }.blocked() shouldBe listOf("Lift")
    }

    test("a lift that its motor holds at its setpoint, or that still moves, is not blocked") {
        lift(TestMatch::height) { 45.0 } shouldBe emptyList()
        lift({ if (it in 16.0..24.0) 0.5 + 0.05 * (it - 16) else TestMatch.height(it) }, { if (it in 16.0..24.0) 45.0 else 6.0 }) shouldBe emptyList()
    }

    test("a lift with a new setpoint that is hardly driven waits for something") {
        lift({ if (it < 17) TestMatch.height(it) else 0.5 }, { if (it in 17.0..24.0) 9.0 else 6.0 }) shouldBe emptyList()
    }

    test("a motor that is known by its id alone, and takes more than 20 A at more than half output without turning, is blocked") {
        devices(21) shouldBe listOf("TalonFX 21")
        devices(21, output = 0.4) shouldBe emptyList()
        devices(21, amperes = 15.0) shouldBe emptyList()
    }

    test("rollers that take 40 A without turning are blocked, by whichever current is logged; without one, they may have no power") {
        fun rollers(vararg currents: String) = TestMatch().apply {
            number("Intake/Motor Output") { if (it in 20.0..24.0) 0.8 else TestMatch.output(it) }
            number("Intake/Velocity RPM") { if (it in 20.0..24.0) 0.0 else 3000 * TestMatch.output(it) }
            for (current in currents) number("Intake/$current") { if (it in 20.0..24.0) 40.0 else 5 + TestMatch.output(it) }
        }.blocked()
        rollers("Supply Current Amps") shouldBe listOf("Intake")
        rollers("Current Amps") shouldBe listOf("Intake")
        rollers() shouldBe emptyList()
    }

    test("rollers that are blocked are found, too, if the log has what their motor is set to") {
        TestMatch().apply {
            number("Intake/Set") { if (it in 20.0..24.0) 0.8 else TestMatch.output(it) }
            number("Intake/Velocity RPM") { if (it in 20.0..24.0) 0.0 else 3000 * TestMatch.output(it) }
            number("Intake/Current Amps") { if (it in 20.0..24.0) 40.0 else 5 + TestMatch.output(it) }
        }.blocked() shouldBe listOf("Intake")
    }

    test("rollers that are driven both ways without turning are blocked, also if a current limit lowers their output; those that hold a piece are not") {
        fun rollers(back: Double) = TestMatch().apply {
            fun isStill(time: Double) = time in 20.0..24.0 || time in 26.0..26.9
            number("Intake/Applied Volts") {
                when {
                    it in 26.0..26.9 -> back
                    isStill(it) -> 4.0
                    else -> 12 * TestMatch.output(it)
                }
            }
            number("Intake/Velocity RPM") { if (isStill(it) || it in 24.0..26.0) 0.0 else 3000 * TestMatch.output(it) }
            number("Intake/Current Amps") {
                when {
                    isStill(it) -> 35 + 0.1 * TestMatch.wave(it)
                    it in 24.0..26.0 -> 0.0
                    else -> 35 * TestMatch.output(it)
                }
            }
        }.blocked()
        rollers(back = -4.0) shouldBe listOf("Intake")
        rollers(back = 4.0) shouldBe emptyList()
    }

    test("several motors that do not turn at once push the robot against something") {
        devices(1, 2, 3, 4) shouldBe emptyList()
    }

    test("a mechanism that stands until the robot is disabled may hold the robot up") {
        devices(21, until = 40.0) shouldBe emptyList()
        lift({ if (it < 25) TestMatch.height(it) else 0.75 }, { if (it > 25) 45.0 else 6.0 }) shouldBe emptyList()
    }

    test("a lift with a setpoint in another unit than its position is not away from it") {
        lift({ if (it < 17) TestMatch.height(it) / 0.03 else 0.5 / 0.03 }, { if (it in 17.0..24.0) 45.0 else 6.0 }) shouldBe emptyList()
    }

    test("a lift that stands away from its setpoint is found in a log of changes, which has no samples meanwhile") {
        fun TestMatch.changes(name: String, at: (Double) -> Double) = cells(name) { if (it == 0.0 || at(it) != at(it - 0.02)) "${at(it)}" else "" }
        fun isAway(most: Double) = TestMatch().apply {
            without("Elevator/Output")
            changes("Elevator/Setpoint", TestMatch::setpoint)
            changes("Elevator/Height") { minOf(TestMatch.setpoint(it - 0.5), most) }
        }.findings().any { it.rule == "Away from its setpoint" }
        isAway(most = 1.0) shouldBe false
        isAway(most = 0.5) shouldBe true
    }

    test("wheels that stand while the robot pushes are not blocked, whatever they are called") {
        fun wheels(vararg names: String) = TestMatch().apply {
            for (name in names) {
                number("$name/Velocity") { if (it in 20.0..24.0) 0.0 else 100 * TestMatch.output(it) }
                number("$name/Current") { if (it in 20.0..24.0) 50.0 + TestMatch.wave(it) else 5.0 + TestMatch.wave(it) }
            }
        }.blocked()
        wheels("Flywheel Gearbox") shouldBe listOf("Flywheel Gearbox")
        wheels("Outer Gearbox", "Inner Gearbox") shouldBe emptyList()
        for (name in listOf("Front Left", "LeftMaster", "Modules/FL")) wheels(name) shouldBe emptyList()
    }

    test("several positions that stop at once show a robot that is held") {
        fun still(vararg ids: Int) = TestMatch().apply {
            for (id in ids) {
                number("TalonFX-$id/Position") { if (it < 24) TestMatch.position(it) else 12.5 }
                number("TalonFX-$id/DutyCycle") { TestMatch.output(it) }
            }
        }.findings().count { it.rule == "Position stands still" }
        still(1) shouldBe 1
        still(1, 2) shouldBe 0
    }
})
