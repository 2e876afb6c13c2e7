package badlog.fetch

import java.nio.file.Path

/**
 * A log that was fetched.
 *
 * @property path where it is on the robot.
 * @property file where it is now.
 * @property bytes how many it has.
 * @property resumedAt how many of them were here before.
 * @property title what match it is of, or null.
 * @property isLog whether it can be read as a log.
 * @property isSalvaged whether something of it is lost.
 */
public class FetchedLog internal constructor(
    public val path: String,
    public val file: Path,
    public val bytes: Long,
    public val resumedAt: Long,
    public val title: String?,
    public val isLog: Boolean,
    public val isSalvaged: Boolean,
)

/**
 * What a robot's folders have for this computer.
 *
 * @property newLogs how many are not here.
 * @property newBytes how many bytes these have.
 * @property knownLogs how many are here.
 */
public class FoundLogs internal constructor(public val newLogs: Int, public val newBytes: Long, public val knownLogs: Int)

/** Hears what a fetch does, on the thread that fetches. What it throws ends the fetch. */
public interface FetchListener {
    /** The robot at [address] let [user] in. */
    public fun connected(address: RobotAddress, user: String) {}

    /** The robot is enabled: nothing is asked of it until it is disabled. */
    public fun waiting(address: RobotAddress) {}

    /** The connection was lost, for the reason of [reason], and is tried again. */
    public fun retrying(address: RobotAddress, reason: String) {}

    /** The robot's folders were looked at. */
    public fun found(logs: FoundLogs) {}

    /** [done] of the [total] bytes of the log [name] are here. */
    public fun advanced(name: String, done: Long, total: Long) {}

    /** A log was fetched. */
    public fun fetched(log: FetchedLog) {}

    /** The robot's log at [path] was passed over, for the reason of [message]; [isGrowing] when it comes with a later fetch. */
    public fun skipped(path: String, message: String, isGrowing: Boolean) {}

    /** The log at [path] was removed from the robot. */
    public fun deleted(path: String) {}
}

/**
 * What came of a fetch.
 *
 * @property address where the robot answered.
 * @property user who was let in.
 * @property fetched the logs that came, the newest first.
 * @property known how many were here already.
 */
public class FetchSummary internal constructor(
    public val address: RobotAddress,
    public val user: String,
    public val fetched: List<FetchedLog>,
    public val known: Int,
)
