package badlog.cli

import badlog.cli.fetch.Robots
import badlog.fetch.DriverStation
import badlog.fetch.FakeRobot
import badlog.fetch.IMPATIENCE
import badlog.files.inFolder
import kotlin.io.path.div

/** Does [work] beside a disabled robot of any team. */
internal fun besideRobot(work: (FakeRobot, Robots) -> Unit) = inFolder { folder ->
    DriverStation().use { station ->
        FakeRobot(folder / "disk").use { robot ->
            work(robot, Robots({ _, _ -> listOf(robot.address(station.port)) }, { folder / "settings" }, password = null, IMPATIENCE))
        }
    }
}
