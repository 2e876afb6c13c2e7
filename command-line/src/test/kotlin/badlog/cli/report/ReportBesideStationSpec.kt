package badlog.cli.report

import badlog.cli.Logged
import badlog.cli.badlog
import badlog.cli.badlogJson
import badlog.cli.with
import badlog.cli.wpilog
import badlog.files.inFolder
import badlog.formats.driverstation.STATION_START
import badlog.formats.driverstation.Status
import badlog.formats.driverstation.TestDslog
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldNotContain
import kotlinx.serialization.json.int
import kotlinx.serialization.json.jsonArray
import kotlinx.serialization.json.jsonObject
import kotlinx.serialization.json.jsonPrimitive
import java.nio.file.Path
import kotlin.io.path.div

class ReportBesideStationSpec : FunSpec({
    /** Enabled from 5 to 8 s of 17. The link is slow and the battery low for the last second of that. */
    val dslog = TestDslog().apply {
        records(250)
        records(100, Status.BOTH_TELEOP)
        repeat(50) { record(Status.BOTH_TELEOP, volts = 6.5, trip = 180) }
        records(450)
    }

    fun Path.robot(battery: Boolean, name: String = "robot.wpilog", ahead: Double = 0.0) = wpilog(
        name,
        listOf(
            Logged("DS:enabled", "boolean", "", listOf(0.5 to false, 2.0 to true, 5.0 to false, 13.0 to false).map { (time, value) -> time + ahead to value }),
            // Its clock began 3 s later.
            Logged("systemTime", "int64", "", listOf(1.0 + ahead to (STATION_START - 2_082_844_800L + 4.5) * 1e6)),
        ) + if (battery) listOf(Logged("Battery Voltage", "double", "", listOf(0.5 to 12.5, 13.0 to 12.0))) else emptyList(),
    )

    fun Path.rules() = with(
        "rules.toml",
        listOf("trip time > 50", "battery < 7").joinToString("\n") { "[[rule]]\nname='$it'\nseverity='warning'\nwhen='$it'\ntext='at {time}'\n" },
    )

    test("rules get the link and the power from the Driver Station's log if the robot's lacks them") {
        inFolder { folder ->
            folder.with("ds/2026_03_07 10_04_05 Sat.dslog", dslog.bytes)
            val arguments = arrayOf<Any>("report", folder.robot(battery = false), "--no-cache", "--rules", folder.rules())
            badlog(*arguments).out shouldNotContain "at 4"
            val ended = badlogJson(*arguments, "--with-ds=${folder / "ds"}").json.single()
            ended.getValue("findings").jsonArray.map { it.jsonObject.getValue("rule").jsonPrimitive.content } shouldBe
                listOf("trip time > 50", "battery < 7")
            ended.getValue("driverStation").jsonObject.getValue("edges").jsonPrimitive.int shouldBe 2
            badlog(*arguments, "--with-ds=${folder / "ds"}").err shouldContain "2 edges of enabled fit within 0 s"
        }
    }

    test("the robot's own signals take precedence, and a match without a Driver Station log is unchanged") {
        inFolder { folder ->
            folder.with("ds/2026_03_07 10_04_05 Sat.dslog", dslog.bytes)
            val robot = folder.robot(battery = true)
            val arguments = arrayOf<Any>("report", robot, "--no-cache", "--csv", "--rules", folder.rules())
            badlog(*arguments, "--with-ds=${folder / "ds"}").out.run {
                this shouldContain "trip time > 50"
                this shouldNotContain "battery < 7"
            }
            // A folder without Driver Station logs.
            val none = folder.with("none/notes.txt", "no log").parent
            badlog(*arguments, "--with-ds=$none").out shouldNotContain "trip time > 50"
            // Without a folder: the log's folder, and those below it.
            badlog(*arguments, "--with-ds").out shouldContain "trip time > 50"
        }
    }

    test("programs, too, learn that a Driver Station log may belong to another robot") {
        inFolder { folder ->
            folder.with("ds/2026_03_07 10_04_05 Sat.dslog", dslog.bytes)
            val robot = folder.robot(battery = false)
            folder.robot(battery = false, name = "rival.wpilog", ahead = 1.0)
            val ended = badlogJson("report", robot, "--no-cache", "--with-ds=${folder / "ds"}").json.single()
            ended.getValue("driverStationDoubt").jsonPrimitive.content shouldContain "or to the robot of rival.wpilog"
        }
    }
})
