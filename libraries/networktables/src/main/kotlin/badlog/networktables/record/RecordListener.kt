package badlog.networktables.record

import java.nio.file.Path

/** Receives the events of a recorder, on its thread. */
interface RecordListener {
    /** The server [name] answers at [address], and its values are recorded from now on. */
    fun connected(name: String, address: ServerAddress) {}

    /** The connection to the server [name] ended because of [reason], part of a sentence; it is looked for again. */
    fun disconnected(name: String, reason: String) {}

    /** A file is finished. */
    fun finished(file: RecordedFile) {}

    /** Something that a person should know: [message] is a sentence, which is also in the log. */
    fun noted(message: String) {}
}

/** Returns that the server [name] answers at [address], as a sentence. */
fun connectedText(name: String, address: ServerAddress): String = "Connected to the $name at $address."

/** Returns that the connection to the server [name] ended because of [reason], as a sentence. */
fun lostText(name: String, reason: String): String = "The connection to the $name was lost ($reason); looking for it."

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
class RecordedFile internal constructor(
    val path: Path,
    val values: Long,
    val topics: Int,
    val bytes: Long,
    val dropped: Long,
    val late: Long,
    val gaps: Int,
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
class RecordProgress internal constructor(val values: Long, val topics: Int, val bytes: Long, val file: Path?, val isConnected: Boolean)
