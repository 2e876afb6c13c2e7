package badlog.spark.lake

import badlog.season.lake.LakeChange
import java.io.Serializable

/**
 * The outcome for one log.
 *
 * @property path the log's path in the lake's table of matches.
 * @property message the reason why it is not in the lake, as a sentence; null if it is.
 * @property isNoLog whether it is something other than a log.
 * @property isSalvaged whether data of the log is lost.
 * @property obsolete the log's former files that the lake no longer needs, relative to the lake.
 */
internal class LogOutcome(
    val path: String,
    val message: String? = null,
    val isNoLog: Boolean = false,
    val isSalvaged: Boolean = false,
    val obsolete: List<String> = emptyList(),
) : Serializable {
    private companion object {
        const val serialVersionUID = 1L
    }
}

/**
 * A message from the task that reads a log to the one that writes tables. It has a change, an outcome, or both; the outcome is reported
 * after the change.
 */
internal class LogPiece(val change: LakeChange?, val outcome: LogOutcome?) : Serializable {
    /** The key that groups pieces by partition; empty for outcomes without a change. */
    val partitionPath: String get() = change?.partitionPath.orEmpty()

    private companion object {
        const val serialVersionUID = 1L
    }
}
