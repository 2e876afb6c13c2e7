package badlog.cli.merge

import badlog.cli.Logged
import badlog.cli.badlog
import badlog.cli.command.ExitCode
import badlog.cli.with
import badlog.cli.wpilog
import badlog.files.inFolder
import badlog.files.readRecording
import badlog.formats.LOG_FORMATS
import badlog.formats.driverstation.STATION_START
import badlog.formats.driverstation.Status
import badlog.formats.driverstation.TestDsevents
import badlog.formats.driverstation.TestDslog
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.nio.file.Path
import kotlin.io.path.createDirectory
import kotlin.io.path.div

/** [STATION_START] in s since 1970. */
private const val START = STATION_START - 2_082_844_800L

/** Enabled from 5 to 8 s and from 9 to 15 s of 17. */
private fun dslog(start: Long = STATION_START) = TestDslog(start = start).records(250).records(150, Status.BOTH_AUTO).records(50)
    .records(300, Status.BOTH_TELEOP).records(100)

/** The robot's log of that, with a clock that began [later] than the Driver Station's log. */
private fun Path.robot(name: String, later: Double, hasTime: Boolean = true) = wpilog(
    name,
    listOf(
        Logged("DS:enabled", "boolean", "", listOf(0.5 to false, 5 - later to true, 8 - later to false, 9 - later to true, 15 - later to false, 16 - later to false)),
        Logged("/Arm/Angle", "double", "", List(20) { it / 2.0 + 0.5 to it.toDouble() }),
    ) + if (hasTime) listOf(Logged("systemTime", "int64", "", listOf(1.0 to (START + 1.5 + later) * 1e6))) else emptyList(),
)

class StationSearchSpec : FunSpec({
    fun Path.stations() {
        with("2026_03_07 10_04_05 Sat.dslog", dslog().bytes)
        with("2026_03_07 10_04_05 Sat.dsevents", TestDsevents().entry(9000, "Info nine").bytes)
        with("2026_03_07 09_04_05 Sat.dslog", dslog(STATION_START - 3600).bytes)
    }

    fun said(vararg arguments: Any) = badlog(*arguments).run { (out + err).replace(Regex("\\s+"), " ") }

    test("the Driver Station log of the same time is aligned by enabling, and the error is reported") {
        inFolder { folder ->
            folder.stations()
            val robot = folder.robot("robot.wpilog", -10.0)
            val said = said("merge", robot, "--with-ds", "-o", folder / "both.wpilog")
            said shouldContain "Sat.dslog by 10 s; 4 edges of enabled fit within 0 s"
            val both = readRecording(folder / "both.wpilog", LOG_FORMATS)
            both.topics.map { it.name } shouldContain "/Arm/Angle"
            both.topics.single { it.name == "Driver Station/Events" }.times?.toList() shouldBe listOf(19.0)
            both.topics.single { it.name == "Driver Station/Battery Voltage" }.run { times?.first() to size } shouldBe (10.0 to 850)
            both.values.filter { it.name == "Start Time" }.map { it.text } shouldBe listOf("2026-03-07 15:03:56 UTC")
        }
    }

    test("Driver Station samples before the robot's time 0 are left out") {
        inFolder { folder ->
            val logs = (folder / "ds").createDirectory()
            logs.stations()
            val robot = folder.robot("robot.wpilog", 3.0)
            said("merge", robot, "--with-ds=$logs", "-o", folder / "both.wpilog") shouldContain "Sat.dslog by -3 s"
            val voltage = readRecording(folder / "both.wpilog", LOG_FORMATS).topics.single { it.name == "Driver Station/Battery Voltage" }
            checkNotNull(voltage.times).first() shouldBe (0.0 plusOrMinus 0.001)
            voltage.size shouldBe 700
        }
    }

    test("a robot's log without a clock gets the only Driver Station log, but not one of several") {
        inFolder { folder ->
            val robot = folder.robot("robot.wpilog", -2.0, hasTime = false)
            said("merge", robot, "--with-ds", "-o", folder / "none.wpilog") shouldContain "No Driver Station log found in"
            folder.with("one.dslog", dslog().bytes)
            said("merge", robot, "--with-ds", "-o", folder / "both.wpilog") shouldContain "4 edges of enabled fit"
            folder.stations()
            val ended = badlog("merge", robot, "--with-ds", "-o", folder / "which.wpilog")
            ended.code shouldBe ExitCode.NOTHING
            ended.err.replace(Regex("\\s+"), " ") shouldContain "to merge one anyway, name it as a log"
        }
    }
})
