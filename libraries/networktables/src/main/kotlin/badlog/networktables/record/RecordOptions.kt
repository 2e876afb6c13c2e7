package badlog.networktables.record

import java.nio.file.Path

/**
 * What is recorded, and where to.
 *
 * @property folder the folder of the logs; it is created.
 * @property isPerEnable whether each time that the robot is enabled gets a file of its own, rather than the whole session.
 * @property isWanted returns whether a topic with this name in the log, such as `NT:/SmartDashboard/Speed`, is recorded; null for all.
 *   Type descriptions and `/FMSInfo` always are.
 * @property isRenamed whether a file that was begun gets its match's name as soon as the robot says it. False where somebody else has it
 *   open: then only a match that is known when its file begins is in the name.
 * @property maxWaitingBytes the size of the values that may wait for the disk before further ones are dropped.
 */
class RecordOptions(
    val folder: Path,
    val isPerEnable: Boolean = false,
    val isWanted: ((name: String) -> Boolean)? = null,
    val isRenamed: Boolean = true,
    val maxWaitingBytes: Long = 64L shl 20,
)
