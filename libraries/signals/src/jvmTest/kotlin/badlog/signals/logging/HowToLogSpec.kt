package badlog.signals.logging

import badlog.expression.signals.Signal
import badlog.expression.signals.SignalKind
import badlog.expression.signals.Vocabulary
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import badlog.signals.vocabulary.SignalTopics
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain

class HowToLogSpec : FunSpec({
    val signals = RuleSet.BUILT_IN.signals

    for ((signal, logged) in LOGGED) {
        test("what is logged for $signal is recognized as that, with its unit or, as WPILib's NetworkTables have it, without") {
            for (unit in listOf(logged.unit.takeIf { it != "ul" }.orEmpty(), "")) {
                // As NetworkTables, AdvantageKit, Epilogue and DogLog, and a bag have it.
                for (folder in listOf("NT:/SmartDashboard/", "/RealOutputs/", "/Robot/", "")) {
                    val name = folder + logged.topic
                    val topics = SignalTopics(signals, Vocabulary(listOf(Signal(name, if (logged.isBoolean) SignalKind.CONDITION else SignalKind.NUMBER, unit)), hasTime = true), timeTopic = null)
                    topics.of(signal).map { it.topic } shouldContain name
                }
            }
        }
    }

    test("each library has a line of its own, with the name of the topic and its value") {
        LoggingLibrary.entries.map { howToLog("battery", it) } shouldBe listOf(
            """SmartDashboard.putNumber("Battery Voltage", RobotController.getBatteryVoltage());""",
            """Logger.recordOutput("Battery Voltage", RobotController.getBatteryVoltage());""",
            """@Logged(name = "Battery Voltage") public double batteryVoltage() { return RobotController.getBatteryVoltage(); }""",
            """DogLog.log("Battery Voltage", RobotController.getBatteryVoltage());""",
            """SignalLogger.writeDouble("Battery Voltage", RobotController.getBatteryVoltage(), "V");""",
            """BadLog.createTopicDouble("Battery Voltage", "V", () -> RobotController.getBatteryVoltage());""",
        )
        howToLog("robot enabled", LoggingLibrary.EPILOGUE).orEmpty() shouldContain "public boolean robotEnabled() { return"
        howToLog("robot enabled", LoggingLibrary.PHOENIX) shouldBe """SignalLogger.writeBoolean("Robot/Enabled", DriverStation.isEnabled());"""
        howToLog("no such signal", LoggingLibrary.BADLOG) shouldBe null
    }

    test("a value that only the Driver Station knows is a signal, and has no line") {
        for (signal in listOf("packet loss", "trip time")) {
            signals.find(signal)?.name shouldBe signal
            isOfDriverStation(signal) shouldBe true
            howToLog(signal, LoggingLibrary.WPILIB) shouldBe null
        }
        isOfDriverStation("battery") shouldBe false
    }
})
