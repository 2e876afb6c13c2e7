package badlog.lib

import edu.wpi.first.wpilibj.DriverStation
import edu.wpi.first.wpilibj.RobotController
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

class WpilibSpec : FunSpec({
    test("up to season 2026, WPILib is found under edu.wpi.first") {
        val wpilib = Wpilib.find(WpilibSpec::class.java.classLoader)
        DriverStation.enabled = false
        wpilib.isEnabled.asBoolean shouldBe false
        DriverStation.enabled = true
        wpilib.isEnabled.asBoolean shouldBe true
        DriverStation.attached = true
        wpilib.isDriverStationAttached.asBoolean shouldBe true
        RobotController.systemTimeValid = true
        wpilib.isClockSet.asBoolean shouldBe true
        wpilib.batteryVoltage?.asDouble shouldBe 12.6
        DriverStation.matchType = DriverStation.MatchType.None
        wpilib.match.get() shouldBe ""
        DriverStation.event = "OHCL"
        DriverStation.matchType = DriverStation.MatchType.Qualification
        DriverStation.matchNumber = 42
        wpilib.event.get() shouldBe "OHCL"
        wpilib.match.get() shouldBe "Q42"
    }

    test("from 2027 on, WPILib is found under org.wpilib") {
        val wpilib = Wpilib.find(Hiding("edu.wpi."))
        wpilib.isEnabled.asBoolean shouldBe false
        wpilib.isDriverStationAttached.asBoolean shouldBe true
        wpilib.isClockSet.asBoolean shouldBe false
        wpilib.batteryVoltage?.asDouble shouldBe 11.9
        wpilib.event.get() + wpilib.match.get() shouldBe "ONTOE7"
    }

    test("without WPILib, the robot counts as enabled and the rest as unknown") {
        val wpilib = Wpilib.find(Hiding("edu.wpi.", "org.wpilib."))
        wpilib.isEnabled.asBoolean shouldBe true
        wpilib.isDriverStationAttached.asBoolean shouldBe false
        wpilib.isClockSet.asBoolean shouldBe true
        wpilib.batteryVoltage shouldBe null
        wpilib.event.get() + wpilib.match.get() shouldBe ""
    }

    test("querying WPILib allocates nothing") {
        val wpilib = Wpilib.find(WpilibSpec::class.java.classLoader)
        val battery = checkNotNull(wpilib.batteryVoltage)
        garbageOf {
            repeat(20_000) { if (wpilib.isEnabled.asBoolean) battery.asDouble }
        } shouldBe 0
    }
})

/** Loads classes as if those under [prefixes] did not exist. */
private class Hiding(vararg val prefixes: String) : ClassLoader(WpilibSpec::class.java.classLoader) {
    override fun loadClass(name: String, resolve: Boolean): Class<*> {
        if (prefixes.any { name.startsWith(it) }) throw ClassNotFoundException(name)
        return super.loadClass(name, resolve)
    }
}
