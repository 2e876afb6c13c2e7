package badlog.spark.lake

import badlog.season.lake.LakeChange
import java.io.Serializable

/**
 * What became of a log.
 *
 * @property path what the lake knows it by.
 * @property message why it is not in the lake, as a sentence; null when it is.
 * @property isNoLog whether it is something else than a log.
 * @property isSalvaged whether the log lost something.
 * @property obsolete the files that the lake had of it and does not need any longer, seen from the lake.
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

/** What goes from the task that read a log to the one that writes tables: a change to them, what to report once it is made, or both. */
internal class LogPiece(val change: LakeChange?, val outcome: LogOutcome?) : Serializable {
    /** The key that brings the pieces of a place together; empty for what is only reported. */
    val place: String get() = change?.place.orEmpty()

    private companion object {
        const val serialVersionUID = 1L
    }
}
