package badlog.fetch

/** Thrown if logs could not be fetched. The message is one sentence for the user: the problem, its place, and the next step. */
sealed class FetchException(override val message: String, cause: Throwable? = null) : Exception(message, cause)

/** No robot answers at any of its addresses. */
class NoRobotException internal constructor(addresses: List<RobotAddress>) :
    FetchException(
        "No robot answers at ${addresses.joinToString()}; connect to its network or by USB, or type its address.",
    )

/**
 * The robot refuses all known users.
 *
 * @property address the address of the robot.
 */
class LoginRefusedException internal constructor(val address: RobotAddress, users: List<String>) :
    FetchException(
        "$address refuses the password of ${users.distinct().joinToString(" and ")}; set BADLOG_ROBOT_PASSWORD, or use --user.",
    )

/** The robot's host key is not trusted. */
class HostKeyRefusedException internal constructor(question: HostKeyQuestion) :
    FetchException(
        if (question.isChanged) {
            "The host key of ${question.address} has changed to ${question.fingerprint}; if the robot was " +
                "reimaged, or another one has its address, use --accept-new-host-key."
        } else {
            "The host key of ${question.address} is unknown (${question.fingerprint}); if this is your robot, use --accept-new-host-key."
        },
    ) {
    /** The address of the robot. */
    val address: RobotAddress = question.address
}

/**
 * The robot does not report whether it is enabled.
 *
 * @property address the address of the robot.
 */
class UnknownStateException internal constructor(val address: RobotAddress, reason: String) :
    FetchException("It is unknown whether the robot at $address is enabled: $reason. Start its program, or use --anyway.")

/** The connection was lost and could not be restored. Copied bytes are kept for the next fetch. */
class LostConnectionException internal constructor(address: RobotAddress, reason: String, cause: Throwable? = null) :
    FetchException("The connection to $address was lost ($reason); fetch again to resume.", cause)

/** There is not enough room on this computer. */
class NoRoomException internal constructor(message: String) : FetchException(message)
