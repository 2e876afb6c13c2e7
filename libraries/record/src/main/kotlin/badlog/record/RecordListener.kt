package badlog.record

import java.nio.file.Path

/** Receives the events of a recorder, on its thread. */
public interface RecordListener {
    /** The server [name] answers at [address], and its values are recorded from now on. */
    public fun connected(name: String, address: ServerAddress) {}

    /** The connection to the server [name] ended because of [reason], part of a sentence; it is looked for again. */
    public fun disconnected(name: String, reason: String) {}

    /** A file is finished. */
    public fun finished(file: RecordedFile) {}

    /** Something that a person should know: [message] is a sentence, which is also in the log. */
    public fun noted(message: String) {}
}

/**
 * A log that was recorded.
 *
 * @property path where it is.
 * @property values the number of values in it.
 * @property topics the number of topics that have values.
 * @property bytes its size.
 * @property dropped the number of values that arrived while it was written, but are missing because the disk was too slow.
 * @property late the number of values whose time is before that of the value before them; a program on the robot's network has another clock.
 * @property gaps how many times the connection to the robot was lost.
 */
public class RecordedFile internal constructor(
    public val path: Path,
    public val values: Long,
    public val topics: Int,
    public val bytes: Long,
    public val dropped: Long,
    public val late: Long,
    public val gaps: Int,
)

/**
 * How far a recording is.
 *
 * @property values the number of values written since the start, in all files.
 * @property topics the number of topics that have values in the current file.
 * @property bytes the size of the current file.
 * @property file the current file, or null.
 * @property isConnected whether the robot's server is connected.
 */
public class RecordProgress internal constructor(
    public val values: Long,
    public val topics: Int,
    public val bytes: Long,
    public val file: Path?,
    public val isConnected: Boolean,
)
