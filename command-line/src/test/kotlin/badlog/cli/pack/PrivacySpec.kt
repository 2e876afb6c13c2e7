package badlog.cli.pack

import badlog.core.recording.Recording
import badlog.core.recording.RecordingFormat
import badlog.core.recording.Value
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe

private fun privacyOf(vararg values: Pair<String, String>) = Privacy(Recording(RecordingFormat.BAG, null, values.map { (name, text) -> Value(name, text) }, emptyList(), 0, emptyList()))

class PrivacySpec : FunSpec({
    val cleaned = listOf(
        "at /home/jane/robot/src/Main.java:12" to "at [path]:12",
        "C:\\Users\\Jane Doe\\robot\\Main.java failed" to "[path] failed",
        "see file:///C:/Users/jane/a.log" to "see [path]",
        "\\\\server\\logs\\a.bag" to "[path]",
        "~/logs/a.bag, then /media/sda1/logs" to "[path], then [path]",
        "lost 10.10.14.2 and 192.168.0.7:5810" to "lost [address] and [address]:5810",
        "roboRIO-1014-FRC.local does not answer" to "[address] does not answer",
        "fe80::1ff:fe23:4567:890a" to "[address]",
        "MAC 00:80:2f:17:d9:0a" to "MAC [address]",
        "by jane@example.org" to "by [user]",
        "FRC 1014, team #254" to "[team], [team]",
    )
    for ((text, left) in cleaned) {
        test("“$text” becomes “$left”") { privacyOf().without(text) shouldBe left }
    }

    val harmless = listOf(
        "/SmartDashboard/Arm/Angle", "12:30:45", "version 2026.1.1", "6.73 V, 250 A", "frc.robot.Robot.robotInit(Robot.java:12)",
        "CAN timeout, Elevator (ID 5)", "https://docs.wpilib.org/en/stable", "std::vector", "teams", "a/b = 3", "1:32.5",
    )
    for (text in harmless) {
        test("“$text” is not private") { privacyOf().without(text) shouldBe text }
    }

    test("known team numbers and user names are removed wherever they are words") {
        val privacy = privacyOf("Team Number" to "1014", "Path" to "/Users/jane/x")
        privacy.without("Jane and 1014, not 11014, 10.14 or janet") shouldBe "[user] and [team], not 11014, 10.14 or janet"
        privacyOf("IP" to "10.2.54.2").without("robot 254") shouldBe "robot [team]"
        privacyOf("Team" to "7").without("7 V") shouldBe "7 V"
    }
})
