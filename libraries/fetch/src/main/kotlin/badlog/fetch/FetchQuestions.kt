package badlog.fetch

/**
 * A robot's host key that is not trusted yet.
 *
 * @property address the address of the robot.
 * @property fingerprint the key's fingerprint, such as `SHA256:…`.
 * @property isChanged whether another key was trusted at this address. A reimaged robot has a new key, and the robots of a team share an
 * address.
 */
class HostKeyQuestion internal constructor(val address: RobotAddress, val fingerprint: String, val isChanged: Boolean)

/** The questions that a person answers before logs can be fetched. Called on the fetching thread, which waits. */
interface FetchQuestions {
    /** Returns whether to trust the robot of [question], now and in the future. */
    fun trusts(question: HostKeyQuestion): Boolean

    /** Returns the password of [user] at [address], after the known ones were refused; null if there is none. */
    fun password(user: String, address: RobotAddress): String?

    companion object {
        /** The answers without a person: no key is trusted, and no password is known. */
        val NOBODY: FetchQuestions = object : FetchQuestions {
            override fun trusts(question: HostKeyQuestion): Boolean = false

            override fun password(user: String, address: RobotAddress): String? = null
        }
    }
}
