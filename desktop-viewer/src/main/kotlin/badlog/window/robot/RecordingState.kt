package badlog.window.robot

import java.nio.file.Path

/**
 * A recording of the data that a robot publishes, as the window shows it.
 *
 * @property isOn whether the window is recording.
 * @property isPerEnable whether each time that the robot is enabled gets a log of its own.
 * @property isOfAll whether the other servers of a 2027 robot and of its Driver Station are also recorded.
 * @property connection the state of the connection to the robot, as a sentence.
 * @property file the log that is being written; null for none.
 * @property amount the amount of data in the log; empty without a log.
 */
internal data class RecordingState(
    val isOn: Boolean = false,
    val isPerEnable: Boolean = false,
    val isOfAll: Boolean = false,
    val connection: String = "",
    val file: Path? = null,
    val amount: String = "",
) {
    /** The condition for which the recording waits, as a sentence; null while a log is being written. */
    val waiting: String?
        get() = when {
            file != null -> null
            isPerEnable -> "A log begins when the robot is enabled."
            else -> "A log begins when the robot answers."
        }
}
