package badlog.window

import badlog.formats.driverstation.Status
import badlog.formats.driverstation.TestDslog
import java.nio.file.Files
import java.nio.file.Path

/**
 * Puts a pair of logs of one match into [folder]; returns the robot's log, `robot.bag`, without link and power. The other is the Driver
 * Station's.
 */
internal fun putPair(folder: Path): Path {
    val dslog = TestDslog().records(250).records(100, Status.BOTH_TELEOP)
    repeat(50) { dslog.record(Status.BOTH_TELEOP, volts = 6.5, trip = 180) }
    Files.write(folder.resolve("2026_03_07 10_04_05 Sat.dslog"), dslog.records(450).bytes)
    val header = """{"topics":[{"name":"Time","unit":"s","attrs":["xaxis","hide"]},{"name":"Robot/Enabled","unit":"ul","attrs":[]},""" +
        """{"name":"Arm/Angle","unit":"deg","attrs":[]}],"values":[{"name":"Start Time","value":"2026-03-07 15:04:08 UTC"}]}"""
    val rows = List(600) { row -> "${row / 50.0},${row in 100 until 250},${row % 90}" }
    val lines = listOf(header, "Time,Robot/Enabled,Arm/Angle") + rows
    return Files.writeString(folder.resolve("robot.bag"), lines.joinToString("\n", postfix = "\n")).toAbsolutePath()
}
