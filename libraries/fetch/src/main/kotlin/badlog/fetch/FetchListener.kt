package badlog.fetch

import java.nio.file.Path

/**
 * A log that was fetched.
 *
 * @property path its path on the robot.
 * @property file its file on this computer.
 * @property bytes its size in bytes.
 * @property resumedAt the number of bytes that were already on this computer.
 * @property title the title of its match, or null.
 * @property isLog whether it can be read as a log.
 * @property isSalvaged whether some of its data is lost.
 */
class FetchedLog internal constructor(
    val path: String,
    val file: Path,
    val bytes: Long,
    val resumedAt: Long,
    val title: String?,
    val isLog: Boolean,
    val isSalvaged: Boolean,
)

/**
 * The logs found in a robot's folders.
 *
 * @property newLogs the number of logs that are not on this computer.
 * @property newBytes their total size in bytes.
 * @property knownLogs the number of logs that are already on this computer.
 */
class FoundLogs internal constructor(val newLogs: Int, val newBytes: Long, val knownLogs: Int)

/** Receives the events of a fetch, on its thread. An exception from it ends the fetch. */
interface FetchListener {
    /** The robot at [address] accepted [user]. */
    fun connected(address: RobotAddress, user: String) {}

    /** The robot is enabled: the fetch waits until it is disabled. */
    fun waiting(address: RobotAddress) {}

    /** The connection was lost because of [reason], and will be retried. */
    fun retrying(address: RobotAddress, reason: String) {}

    /** The robot's folders were listed. */
    fun found(logs: FoundLogs) {}

    /** [done] of the [total] bytes of the log [name] are on this computer. */
    fun advanced(name: String, done: Long, total: Long) {}

    /** A log was fetched. */
    fun fetched(log: FetchedLog) {}

    /** The robot's log at [path] was skipped; [message] says why. With [isGrowing], a later fetch will include it. */
    fun skipped(path: String, message: String, isGrowing: Boolean) {}

    /** The log at [path] was removed from the robot. */
    fun deleted(path: String) {}
}

/**
 * The result of a fetch.
 *
 * @property address the address of the robot.
 * @property user the user that was accepted.
 * @property fetched the fetched logs, newest first.
 * @property known the number of logs that were already on this computer.
 */
class FetchSummary internal constructor(val address: RobotAddress, val user: String, val fetched: List<FetchedLog>, val known: Int)
