package badlog.fetch

import java.nio.file.Path
import java.time.Duration

/**
 * What to fetch, and how.
 *
 * @property folder where logs go; made if need be.
 * @property robotFolders the folders of the robot to look into; null for those into which WPILib logs.
 * @property anyway true to fetch even while the robot may be enabled.
 * @property bytesPerSecond how many bytes may come in a second, or null for as many as can.
 * @property deleteOlderThan how old a log must be that is removed from the robot, if it is safely here; null to remove nothing.
 * @property acceptsNewHostKeys true to trust every robot without asking.
 * @property password the robot's password, tried before the known ones; or null.
 */
public class FetchOptions(
    public val folder: Path,
    public val robotFolders: List<String>? = null,
    public val anyway: Boolean = false,
    public val bytesPerSecond: Long? = null,
    public val deleteOlderThan: Duration? = null,
    public val acceptsNewHostKeys: Boolean = false,
    public val password: String? = null,
)
