package badlog.rules

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

/** A weak drive motor is found by whichever names the log has for the wheels. */
class WheelNamesSpec : FunSpec({
    fun TestMatch.weakWheels() = findings().filter { it.rule == "Module draws less current" }.map { it.text.substringBefore(" drives") }

    fun weak(vararg names: String) = TestMatch().apply {
        swerve()
        for ((at, name) in names.withIndex()) number(name) { if (at == 2) 10.0 else 20.0 }
    }.weakWheels()

    /** [name] for each corner. */
    fun corners(name: String) = listOf("fl", "fr", "bl", "br").map { name.replace("%s", it) }.toTypedArray()

    test("modules of a list of states whose motors are named by their corners") {
        weak("frontLeft/driveStatorCurrent_A", "frontRight/driveStatorCurrent_A", "backLeft/driveStatorCurrent_A", "backRight/driveStatorCurrent_A") shouldBe
            listOf("Back Left")
    }

    test("corners as letters in snake case") {
        weak("fl_drive_amps", "fr_drive_amps", "bl_drive_amps", "br_drive_amps") shouldBe listOf("Back Left")
    }

    test("currents of steering motors, and of three corners, are no drive") {
        weak("fl_turn_amps", "fr_turn_amps", "bl_turn_amps", "br_turn_amps") shouldBe emptyList()
        weak("fl_drive_amps", "fr_drive_amps", "bl_drive_amps") shouldBe emptyList()
        for (name in listOf("%s_turning_amps", "%s/Angle Current", "%s Rotation Amps")) weak(*corners(name)) shouldBe emptyList()
    }

    test("motors of other mechanisms at four corners are no drive") {
        weak(*corners("Shooter %s Current")) shouldBe emptyList()
        weak(*corners("Climber %s Amps")) shouldBe emptyList()
    }

    test("of modules that are named by their corners, only drive motors are compared") {
        fun weakOf(name: String) = TestMatch().apply {
            for ((at, corner) in listOf("Front Left", "Front Right", "Back Left", "Back Right").withIndex()) {
                number("$corner Speed") { 2 * TestMatch.output(it) }
                number("$corner Angle") { 40 * TestMatch.wave(it) }
                number(name.replace("%s", corner)) { if (at == 2) 10.0 else 20.0 }
            }
        }.weakWheels()
        weakOf("%s Drive Current") shouldBe listOf("Back Left")
        weakOf("%s Angle Current") shouldBe emptyList()
        weakOf("Shooter %s Current") shouldBe emptyList()
    }

    test("the channel of a weak motor is not named beside the motor") {
        fun channels(isMotorLogged: Boolean) = TestMatch().apply {
            swerve()
            from(15.0, CHANNEL) { (TestMatch.load(it) / 10).toString() }
            if (isMotorLogged) for ((at, name) in listOf("fl", "fr", "bl", "br").withIndex()) number("${name}_drive_amps") { if (at == 2) 10.0 else 20.0 }
        }.findings().count { it.rule == "Channel lost its share" }
        channels(isMotorLogged = false) shouldBe 1
        channels(isMotorLogged = true) shouldBe 0
    }
})
