package badlog.networktables.record

import java.nio.file.Path

/** Receives the events of a recorder, on its thread. */
interface RecordListener {
    /** Called when the server [name] answers at [address]. Its values are recorded from now on. */
    fun connected(name: String, address: ServerAddress) {}

    /**
     * Called when the connection to the server [name] ends because of [reason], part of a sentence. The recorder looks for the server
     * again.
     */
    fun disconnected(name: String, reason: String) {}

    /** Called when a file is finished. */
    fun finished(file: RecordedFile) {}

    /** Called with a [message] for people, a sentence that is also in the log. */
    fun noted(message: String) {}
}

/** Returns a sentence about the connection to the server [name] at [address]. */
fun connectedText(name: String, address: ServerAddress): String = "Connected to the $name at $address."

/** Returns a sentence about the connection to the server [name], lost because of [reason]. */
fun lostText(name: String, reason: String): String = "The connection to the $name was lost ($reason); looking for it."

/**
 * A recorded log.
 *
 * @property path its file.
 * @property values the number of values in it.
 * @property topics the number of topics that have values.
 * @property bytes its size in bytes.
 * @property dropped the number of received values that are missing because the disk was too slow.
 * @property late the number of values that are earlier than the previous one of their topic, because a program on the robot's network has
 *   another clock.
 * @property gaps the number of times that the connection to the robot was lost.
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
 * The progress of a recording.
 *
 * @property values the number of values written since the start, in all files.
 * @property topics the number of topics that have values in the current file.
 * @property bytes the size of the current file in bytes.
 * @property file the current file; null if none is open.
 * @property isConnected whether the robot's server is connected.
 */
class RecordProgress internal constructor(val values: Long, val topics: Int, val bytes: Long, val file: Path?, val isConnected: Boolean)
