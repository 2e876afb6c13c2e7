package badlog.lib

import badlog.core.waiting.eventually
import edu.wpi.first.networktables.DoubleTopic
import edu.wpi.first.wpilibj.DriverStation
import edu.wpi.first.wpilibj.RobotController
import edu.wpi.first.wpilibj.TimedRobot
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainAll
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import org.wpilib.telemetry.Telemetry
import java.io.File

private val root = generateSequence(File("").absoluteFile) { it.parentFile }
    .first { File(it, "settings.gradle.kts").exists() }

private val robots = mapOf<String, () -> TimedRobot>(
    "Java" to { frc.robot.Robot() },
    "Kotlin" to { frc.kotlinrobot.Robot() },
)

private fun logIn(folder: File): File? = folder.listFiles().orEmpty().singleOrNull { it.name.startsWith("FRC_") }

private fun bytesOf(file: File): ByteArray = file.readBytes().let { if (file.extension == "gz") inflated(it) else it }

class GuideSpec : FunSpec({
    test("the robots in docs/robot.md equal the tested ones") {
        val guide = File(root, "docs/robot.md").readText()
        val sources = File(root, "jvm-robot/src/test")
        guide shouldContain "```java\n" + File(sources, "java/frc/robot/Robot.java").readText() + "```"
        guide shouldContain "```kotlin\n" + File(sources, "kotlin/frc/kotlinrobot/Robot.kt").readText() + "```"
    }

    test("the robots in docs/wpilib-logging.md equal the tested ones, and set the same properties in both seasons") {
        val guide = File(root, "docs/wpilib-logging.md").readText()
        for (season in listOf("2026", "2027")) {
            val source = File(root, "jvm-robot/src/test/java/frc/robot$season/Robot.java").readText()
            guide shouldContain "```java\n" + source.replace("package frc.robot$season;", "package frc.robot;") + "```"
        }
        frc.robot2026.Robot().robotPeriodic()
        frc.robot2027.Robot().robotPeriodic()
        val telemetryProperties = Telemetry.PROPERTIES.entries.associate { (name, properties) ->
            "/$name" to properties.entries.sortedByDescending { it.key }.joinToString(", ", "{", "}") { "\"${it.key}\": ${it.value}" }
        }
        telemetryProperties shouldBe DoubleTopic.PROPERTIES
    }

    test("the README's robot is a part of the guide's") {
        val example = File(root, "README.md").readText().substringAfter("```java\n").substringBefore("```")
        val guide = File(root, "jvm-robot/src/test/java/frc/robot/Robot.java").readLines()
        guide shouldContainAll example.lines()
    }

    for ((name, make) in robots) {
        test("the robot in $name logs") {
            val logs = File("logs").absoluteFile
            logs.deleteRecursively()
            DriverStation.enabled = true
            DriverStation.event = "OHCL"
            DriverStation.matchType = DriverStation.MatchType.Qualification
            DriverStation.matchNumber = 42
            RobotController.systemTimeValid = true
            standardErrorOf {
                val robot = make()
                // The guide's robots start their logs themselves, so these go by the system's time.
                eventually("ten lines of the robot in $name") {
                    robot.robotPeriodic()
                    logIn(logs)?.let { bytesOf(it).decodeToString().lines().size > 10 } == true
                }
                BadLog.init(File(logs, "other.bag").path).close()
            }
            val recording = recordingIn(bytesOf(checkNotNull(logIn(logs))))
            recording.topics.map { it.name } shouldContainAll
                listOf("Time", "Robot/Battery Voltage", "Arm/Angle", "Arm/Events")
            recording.values.map { it.name } shouldContainAll listOf("Arm/P", "Event Name", "Match Number")
            recording.topics.first { it.name == "Arm/Target" }.samples.last() shouldBe 45.0
            recording.problems.filter { it.line != null }.shouldBeEmpty()
            logs.deleteRecursively()
        }
    }
})
