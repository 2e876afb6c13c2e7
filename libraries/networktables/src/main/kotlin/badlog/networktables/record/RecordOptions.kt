package badlog.networktables.record

import java.nio.file.Path

/**
 * The settings of a recorder: its folder, files and topics.
 *
 * @property folder the folder for the logs; created if it does not exist.
 * @property isPerEnable whether each enabled period gets a file of its own; otherwise the whole session is one file.
 * @property isWanted returns whether a topic with this name in the log, such as `NT:/SmartDashboard/Speed`, is recorded; null for all. Type
 *   descriptions and `/FMSInfo` always are.
 * @property isRenamed whether an open file is renamed as soon as the robot reports its match. Set it to false if another program has the
 *   file open: the name then includes only a match known when the file begins.
 * @property maxWaitingBytes the maximum size of values waiting for the disk, in bytes; further values are dropped.
 */
class RecordOptions(
    val folder: Path,
    val isPerEnable: Boolean = false,
    val isWanted: ((name: String) -> Boolean)? = null,
    val isRenamed: Boolean = true,
    val maxWaitingBytes: Long = 64L shl 20,
)
