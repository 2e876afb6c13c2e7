package badlog.record

import java.nio.file.Path

/**
 * What is recorded, and where to.
 *
 * @property folder the folder of the logs; it is created.
 * @property isPerEnable whether each time that the robot is enabled gets a file of its own, rather than the whole session.
 * @property isWanted returns whether a topic with this name in the log, such as `NT:/SmartDashboard/Speed`, is recorded; null for all.
 *   Type descriptions and `/FMSInfo` always are.
 * @property maxWaitingBytes the size of the values that may wait for the disk before further ones are dropped.
 */
class RecordOptions(
    val folder: Path,
    val isPerEnable: Boolean = false,
    val isWanted: ((name: String) -> Boolean)? = null,
    val maxWaitingBytes: Long = 64L shl 20,
)
