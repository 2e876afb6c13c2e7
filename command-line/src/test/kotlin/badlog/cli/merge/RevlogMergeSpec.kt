package badlog.cli.merge

import badlog.cli.Logged
import badlog.cli.badlog
import badlog.cli.with
import badlog.cli.wpilog
import badlog.files.inFolder
import badlog.files.readRecording
import badlog.formats.LOG_FORMATS
import badlog.formats.wpilog.WpilogFormat
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.file.Path
import kotlin.io.path.createDirectory
import kotlin.io.path.div

/**
 * The bytes of a `.revlog` of Spark 3, which is at half of its output in [driven] s. A status frame follows every 20 ms from [from] s until
 * 30 s.
 */
private fun revlog(from: Double, driven: List<ClosedRange<Double>>): ByteArray {
    val frames = ((from * 50).toInt() until 1500).map { it * 20 }
    val bytes = ByteBuffer.allocate(frames.size * 20).order(ByteOrder.LITTLE_ENDIAN)
    for (millis in frames) {
        // A record of 16 bytes of status: its kind is one byte, its size two bytes.
        bytes.put(0b0100).put(2).putShort(16)
        bytes.putInt(millis).putInt((2 shl 24) or (5 shl 16) or (46 shl 10) or 3)
        bytes.putLong(if (driven.any { millis / 1000.0 in it }) 16221L else 0L)
    }
    return bytes.array()
}

class RevlogMergeSpec : FunSpec({
    fun said(vararg arguments: Any) = badlog(*arguments).run { (out + err).replace(Regex("\\s+"), " ") }

    fun outputs(driven: List<ClosedRange<Double>>) = List(1500) { it / 50.0 }.map { time -> time to if (driven.any { time in it }) 0.5 else 0.0 }

    val arm = listOf(3.0..5.0, 7.0..8.5, 12.0..20.0)

    test("the log of REV's motor controllers is put where their motors were driven in the robot's log, and the error is reported") {
        inFolder { folder ->
            val robot = folder.wpilog("robot.wpilog", listOf(Logged("Arm/Applied Output", "double", "", outputs(arm))))
            val late = arm.map { it.start + 0.6..it.endInclusive + 0.6 }
            val said = said("merge", robot, folder.with("REV_1.revlog", revlog(1.0, late)), "-o", folder / "both.wpilog")
            said shouldContain "REV_1.revlog by -0.6 s; 6 edges of motors driven fit within 0 s"
            val both = readRecording(folder / "both.wpilog", LOG_FORMATS)
            both.topics.single { it.name == "REV/Spark-3/APPLIED_OUTPUT" }.times?.first() shouldBe (0.4 plusOrMinus 0.001)
        }
    }

    test("samples of motor controllers from before the robot's 0 are left out, rather than moved") {
        inFolder { folder ->
            val robot = folder.wpilog("robot.wpilog", listOf(Logged("Arm/Applied Output", "double", "", outputs(arm))))
            val late = arm.map { it.start + 2..it.endInclusive + 2 }
            val said = said("merge", robot, folder.with("REV_1.revlog", revlog(0.0, late)), "-o", folder / "both.wpilog")
            said shouldContain "REV_1.revlog by -2 s"
            said shouldContain Regex("; without [\\d,]+ samples before 0")
            val output = readRecording(folder / "both.wpilog", LOG_FORMATS).topics.single { it.name == "REV/Spark-3/APPLIED_OUTPUT" }
            output.times?.first() shouldBe (0.02 plusOrMinus 0.021)
            // The first start of the motor in both.
            output.times?.get(output.samples.indexOfFirst { it > 0.1 }) shouldBe (3.0 plusOrMinus 0.021)
        }
    }

    test("a given offset leaves out no sample: it is refused if the log would begin before 0") {
        inFolder { folder ->
            val robot = folder.wpilog("robot.wpilog", listOf(Logged("Arm/Applied Output", "double", "", outputs(arm))))
            val motors = folder.with("REV_1.revlog", revlog(1.0, arm))
            fun samplesIn(log: Path) = readRecording(log, LOG_FORMATS).topics.filter { it.name.startsWith("REV/") }.sumOf { it.times?.size ?: 0 }
            said("merge", robot, motors, "--offset", "REV_1.revlog=-2", "-o", folder / "both.wpilog") shouldContain "REV_1.revlog would start before 0"
            said("merge", robot, motors, "--offset", "REV_1.revlog=-0.5", "-o", folder / "both.wpilog") shouldNotContain "samples before 0"
            samplesIn(folder / "both.wpilog") shouldBe samplesIn(motors)
        }
    }

    test("--align finds the clock of each log, even beside one of motor controllers and if the first would begin before 0") {
        inFolder { folder ->
            fun enabled(late: Double) = listOf(late to false, late + 3 to true, late + 20 to false, late + 22 to true, late + 29 to false)
            val early = folder.wpilog("a.wpilog", listOf(Logged("a/Robot Enabled", "boolean", "", enabled(5.0)), Logged("a/x", "double", "", listOf(0.0 to 1.0))))
            val robot = folder.wpilog("b.wpilog", listOf(Logged("b/Robot Enabled", "boolean", "", enabled(0.0)), Logged("Arm/Applied Output", "double", "", outputs(arm))))
            val motors = folder.with("REV_1.revlog", revlog(1.0, arm.map { it.start + 0.6..it.endInclusive + 0.6 }))
            for (order in listOf(listOf(early, robot, motors), listOf(motors, robot, early))) {
                val said = said("merge", *order.toTypedArray(), "--align", "enabled", "-o", folder / "all.wpilog", "--force")
                said shouldContain "b.wpilog by 5 s"
                said shouldContain "REV_1.revlog by 4.4 s"
            }
        }
    }

    test("a ZIP does not state the clock of a log that was found beside one with an open clock") {
        inFolder { folder ->
            fun enabled(late: Double) = listOf(late to false, late + 3 to true, late + 20 to false, late + 22 to true, late + 29 to false)
            val first = folder.wpilog("a_Q3.wpilog", listOf(Logged("a/Robot Enabled", "boolean", "", enabled(12.0)), Logged("a/x", "double", "", listOf(12.0 to 1.0))))
            val robot = folder.wpilog("b_Q3.wpilog", listOf(Logged("b/Robot Enabled", "boolean", "", enabled(0.0)), Logged("Arm/Applied Output", "double", "", outputs(arm))))
            val motors = folder.with("REV_Q3.revlog", revlog(1.0, arm.map { it.start + 0.6..it.endInclusive + 0.6 }))
            said("merge", first, robot, motors, "-o", folder / "m.zip").run {
                this shouldContain "open: $robot"
                this shouldContain "open: $motors"
            }
            val shown = said("info", folder / "m.zip")
            shown shouldContain "b_Q3.wpilog robot: moved by 12.0 s"
            shown shouldContain Regex("REV_Q3.revlog motors: moved by 11\\.[34]\\d* s")
        }
    }

    test("with the Driver Station log, a ZIP gets the logs of motors near the robot's log, but none that may be of another match") {
        inFolder { folder ->
            folder.with("ds/2026_03_07 10_04_05 Sat.dslog", stationLog().bytes)
            val enabled = listOf(0.0 to false, 4.0 to true, 7.0 to false, 8.0 to true, 14.0 to false, 15.0 to false)
            val robot = (folder / "robot").createDirectory().wpilog(
                "robot_Q3.wpilog",
                listOf(Logged("Robot Enabled", "boolean", "", enabled), Logged("Arm/Applied Output", "double", "", outputs(arm))),
            )
            folder.with("rev/REV_Q3.revlog", revlog(1.0, arm.map { it.start + 0.6..it.endInclusive + 0.6 }))
            folder.with("rev/still_Q3.revlog", revlog(1.0, emptyList()))
            folder.with("rev/REV_Q4.revlog", revlog(1.0, arm))
            val said = said("merge", robot, "--with-ds=${folder / "ds"}", "-o", folder / "match.zip")
            said shouldContain "3 logs, unchanged"
            said shouldContain "REV_Q3.revlog by -0.6 s"
            said shouldContain Regex("left out: \\S+still_Q3.revlog fits none of the robots' logs")
            said shouldNotContain "REV_Q4"
            // Without a ZIP, only the named logs are merged.
            said("merge", robot, "--with-ds=${folder / "ds"}", "-o", folder / "both.wpilog") shouldNotContain "REV"
        }
    }

    test("every command calls it a REV log, and names its output like a WPILOG") {
        inFolder { folder ->
            val log = folder.with("REV_1.revlog", revlog(1.0, arm))
            said("info", log) shouldContain "format REV log,"
            badlog("info", log, "--json").out shouldContain "\"format\":\"revlog\""
            said("info", log, "--x", "Time") shouldContain "is a REV log, whose x axis is always the time"
            said("cut", log, "--from", "5")
            readRecording(folder / "REV_1.cut.wpilog", LOG_FORMATS).format shouldBe WpilogFormat
        }
    }

    test("where no motor shows it, the log stays as it is, since both count from the start of the robot's program") {
        inFolder { folder ->
            val robot = folder.wpilog("robot.wpilog", listOf(Logged("Arm/Angle", "double", "", outputs(arm))))
            val said = said("merge", robot, folder.with("REV_1.revlog", revlog(1.0, arm)), "-o", folder / "both.wpilog")
            said shouldNotContain "moved"
            readRecording(folder / "both.wpilog", LOG_FORMATS).topics.single { it.name == "REV/Spark-3/APPLIED_OUTPUT" }.times?.first() shouldBe 1.0
        }
    }
})
