package badlog.cli.fetch

import badlog.fetch.Patience
import badlog.fetch.RobotAddress
import badlog.files.UserFolders
import java.nio.file.Path

/**
 * The addresses and passwords of robots.
 *
 * @property addressesOf returns the addresses of a robot that a person typed, with the given user unless that is
 * null.
 * @property settings returns the folder of settings.
 * @property password the robot's password; null to use the known ones.
 * @property patience the time to wait for an answer.
 */
internal class Robots(
    val addressesOf: (robot: String, user: String?) -> List<RobotAddress>,
    settings: () -> Path,
    val password: String?,
    val patience: Patience = Patience(),
) {
    val settings: Path by lazy(settings)

    companion object {
        /** Returns the robots on this computer's network. */
        fun ofSystem() = Robots(RobotAddress::besideDriverStation, {
            UserFolders.ofSystem().settings
        }, System.getenv("BADLOG_ROBOT_PASSWORD"))
    }
}
