package badlog.window.robot

import java.nio.file.Path

/**
 * A recording of what a robot publishes, as the window shows it.
 *
 * @property isOn whether somebody records.
 * @property isPerEnable whether each time that the robot is enabled gets a log of its own.
 * @property isOfAll whether the servers are recorded that a robot of 2027 and its Driver Station have besides.
 * @property connection whether the robot answers, as a sentence.
 * @property file the log that is being written; null for none.
 * @property amount what the log has so far; empty without a log.
 */
internal data class RecordingState(
    val isOn: Boolean = false,
    val isPerEnable: Boolean = false,
    val isOfAll: Boolean = false,
    val connection: String = "",
    val file: Path? = null,
    val amount: String = "",
) {
    /** What the recording waits for, as a sentence; null while a log is written. */
    val waiting: String?
        get() = when {
            file != null -> null
            isPerEnable -> "A log begins when the robot is enabled."
            else -> "A log begins when the robot answers."
        }
}
