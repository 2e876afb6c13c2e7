package badlog.cli.fetch

import badlog.fetch.Patience
import badlog.fetch.RobotAddress
import badlog.file.UserFolders
import java.nio.file.Path

/**
 * Where robots answer, and what is known of them.
 *
 * @property addressesOf the places of a robot that a person typed, and of the user where that is not null.
 * @property settings the folder of what is to be kept.
 * @property password the robot's password, or null for the known ones.
 * @property patience how long is waited for what.
 */
internal class Robots(
    val addressesOf: (robot: String, user: String?) -> List<RobotAddress>,
    settings: () -> Path,
    val password: String?,
    val patience: Patience = Patience(),
) {
    val settings: Path by lazy(settings)

    companion object {
        /** Those of the network that this computer is in. */
        fun ofSystem() = Robots(RobotAddress::of, { UserFolders.ofSystem().settings }, System.getenv("BADLOG_ROBOT_PASSWORD"))
    }
}
