package badlog.viewer.shown.outline

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class TargetNameSpec : FunSpec({
    fun arePair(target: String, actual: String): Boolean {
        val one = TargetName.of(target)
        val other = TargetName.of(actual)
        return one != null && other != null && one.isTarget && !other.isTarget && one.words == other.words
    }

    test("target and actual of one thing differ in one word, in any place and spelling") {
        arePair("/Chassis/TargetFrontLeftModuleState/speed", "/Chassis/ActualFrontLeftModuleState/speed") shouldBe true
        arePair("/RealOutputs/SwerveStates/Setpoints[2]/speed", "/RealOutputs/SwerveStates/Measured[2]/speed") shouldBe true
        arePair("Arm/Angle Setpoint", "Arm/Angle") shouldBe true
        arePair("Arm/angle_set_point", "Arm/angle_measured") shouldBe true
        arePair("Arm/commandedAngle", "Arm/Angle") shouldBe true
        arePair("NT:/PathPlanner/targetPose", "NT:/PathPlanner/currentPose") shouldBe true
        arePair("RPM goal", "rpm") shouldBe true
    }

    test("other modules, other fields, and two topics of the same kind are not a pair") {
        arePair("/Chassis/TargetFrontLeft/speed", "/Chassis/ActualFrontRight/speed") shouldBe false
        arePair("/Chassis/TargetFrontLeft/speed", "/Chassis/ActualFrontLeft/angle") shouldBe false
        arePair("Arm/Setpoint", "Wrist/Setpoint") shouldBe false
        arePair("Arm/Target Goal", "Arm") shouldBe false
    }

    test("a current in amperes is not the actual value of a target") {
        arePair("Elevator/Target", "Elevator/Current") shouldBe false
        arePair("Elevator/Target Height", "Elevator/Current Height") shouldBe true
    }
})
