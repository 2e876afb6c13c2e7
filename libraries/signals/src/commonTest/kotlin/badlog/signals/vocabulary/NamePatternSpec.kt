package badlog.signals.vocabulary

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.property.Arb
import io.kotest.property.arbitrary.Codepoint
import io.kotest.property.arbitrary.element
import io.kotest.property.arbitrary.string
import io.kotest.property.checkAll

class NamePatternSpec : FunSpec({
    test("a name may be written in any way") {
        val pattern = NamePattern("*battery voltage")
        for (name in listOf("System/Battery Voltage", "BatteryVoltage", "NT:/pdp/battery_voltage", "a/BATTERY-VOLTAGE")) {
            pattern.matches(name) shouldBe true
        }
        pattern.matches("Battery Voltage Limit") shouldBe false
        NamePattern("Arm/Angle").matches("Big Arm/Angle") shouldBe false
    }

    test("the part of a name up to the end of the last star is the device") {
        NamePattern("*velocity").deviceIn("Drivetrain/Left Velocity") shouldBe "Drivetrain/Left"
        NamePattern("*/applied volts").deviceIn("Drive/Module0/Applied_Volts") shouldBe "Drive/Module0"
        NamePattern("*TalonFX*/Duty Cycle").deviceIn("Phoenix6/TalonFX-1/DutyCycle") shouldBe "Phoenix6/TalonFX-1"
        NamePattern("Battery").deviceIn("Battery") shouldBe "Battery"
    }

    test("a star matches the same as in the corresponding regular expression") {
        val letters = Arb.element("ab*".map { Codepoint(it.code) })
        checkAll(Arb.string(0, 6, letters), Arb.string(0, 8, Arb.element("ab".map { Codepoint(it.code) }))) { pattern, name ->
            NamePattern(pattern).matches(name) shouldBe Regex(pattern.replace("*", ".*")).matches(name)
        }
    }
})
