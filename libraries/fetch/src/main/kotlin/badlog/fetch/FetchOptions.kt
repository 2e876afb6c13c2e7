package badlog.fetch

import java.nio.file.Path
import java.time.Duration

/**
 * The options of a fetch.
 *
 * @property folder the folder for logs; created if necessary.
 * @property robotFolders the folders of the robot to search; null for WPILib's log folders, and for bags in the users' home folders.
 * @property anyway true to fetch even while the robot may be enabled.
 * @property bytesPerSecond the maximum number of bytes per second, or null for no limit.
 * @property deleteOlderThan the age from which logs are removed from the robot, once they are safely on this computer; null to remove
 * nothing.
 * @property acceptsNewHostKeys true to trust every robot without asking.
 * @property password the robot's password, tried before the known ones; or null.
 */
class FetchOptions(
    val folder: Path,
    val robotFolders: List<String>? = null,
    val anyway: Boolean = false,
    val bytesPerSecond: Long? = null,
    val deleteOlderThan: Duration? = null,
    val acceptsNewHostKeys: Boolean = false,
    val password: String? = null,
)
