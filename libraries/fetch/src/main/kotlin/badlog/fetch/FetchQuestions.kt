package badlog.fetch

/**
 * A key that a robot has and that nobody has trusted yet.
 *
 * @property address where it answers.
 * @property fingerprint the key's, such as `SHA256:…`.
 * @property isChanged whether another key was trusted at this address: robots get a new one when they are imaged anew, and two robots
 *   of a team share an address.
 */
public class HostKeyQuestion internal constructor(
    public val address: RobotAddress,
    public val fingerprint: String,
    public val isChanged: Boolean,
)

/** What a person is asked before logs can be fetched. Called on the thread that fetches, which waits. */
public interface FetchQuestions {
    /** Whether the robot of [question] is to be trusted, now and from now on. */
    public fun trusts(question: HostKeyQuestion): Boolean

    /** The password of [user] at [address], after the known ones were refused; null for none. */
    public fun password(user: String, address: RobotAddress): String?

    public companion object {
        /** Nobody is there: no key is trusted, and no password is known. */
        public val NOBODY: FetchQuestions = object : FetchQuestions {
            override fun trusts(question: HostKeyQuestion): Boolean = false

            override fun password(user: String, address: RobotAddress): String? = null
        }
    }
}
