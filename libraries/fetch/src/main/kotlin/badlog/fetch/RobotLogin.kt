package badlog.fetch

import org.apache.sshd.client.SshClient
import org.apache.sshd.client.auth.password.PasswordIdentityProvider
import org.apache.sshd.client.auth.password.UserAuthPasswordFactory
import org.apache.sshd.client.config.hosts.HostConfigEntryResolver
import org.apache.sshd.client.session.ClientSession
import org.apache.sshd.common.config.keys.KeyUtils
import org.apache.sshd.common.config.keys.PublicKeyEntry
import org.apache.sshd.common.digest.BuiltinDigests
import org.apache.sshd.common.keyprovider.KeyIdentityProvider
import org.apache.sshd.core.CoreModuleProperties
import org.apache.sshd.sftp.SftpModuleProperties
import java.io.IOException
import java.security.PublicKey

/**
 * Logs into robots, only with passwords. The person's own SSH keys and settings are not used. Must be closed.
 *
 * @param password a password to try before the known ones, or null.
 */
internal class RobotLogin(
    private val hosts: KnownHosts,
    private val questions: FetchQuestions,
    private val acceptsNewKeys: Boolean,
    private val password: String?,
    private val patience: Patience,
) : AutoCloseable {
    // The last key that a robot presented, trusted or not.
    @Volatile
    private var shownKey: PublicKey? = null

    // Passwords that a person typed, for reconnecting.
    private val typed = HashMap<String, String>()

    private val client = SshClient.setUpDefaultClient().apply {
        hostConfigEntryResolver = HostConfigEntryResolver.EMPTY
        keyIdentityProvider = KeyIdentityProvider.EMPTY_KEYS_PROVIDER
        userAuthFactories = listOf(UserAuthPasswordFactory.INSTANCE)
        CoreModuleProperties.IDLE_TIMEOUT.set(this, patience.answer)
        CoreModuleProperties.NIO2_READ_TIMEOUT.set(this, patience.answer.plus(patience.silence))
        SftpModuleProperties.SFTP_CHANNEL_OPEN_TIMEOUT.set(this, patience.answer)
        setServerKeyVerifier { _, _, key ->
            shownKey = key
            hosts.knows(PublicKeyEntry.toString(key))
        }
        start()
    }

    /**
     * Returns a connection to the robot at [address], with the first of its users that is accepted.
     *
     * @throws HostKeyRefusedException if its host key is not trusted.
     * @throws LoginRefusedException if no user is accepted.
     * @throws IOException if it does not answer.
     */
    fun into(address: RobotAddress): RobotConnection {
        for (login in address.logins) {
            for (word in listOfNotNull(typed[login.user], password, login.password)) connect(address, login.user, word)?.let { return it }
        }
        val user = address.logins.first().user
        repeat(TRIES) {
            val word = questions.password(user, address) ?: throw LoginRefusedException(address, address.logins.map { it.user })
            connect(address, user, word)?.let { connection ->
                typed[user] = word
                return connection
            }
        }
        throw LoginRefusedException(address, listOf(user))
    }

    /** Returns a connection; null if the robot refuses [user] with the password [word]. */
    private fun connect(address: RobotAddress, user: String, word: String): RobotConnection? {
        val session = open(address, user)
        try {
            session.passwordIdentityProvider = PasswordIdentityProvider { listOf(word) }
            val auth = session.auth()
            RobotConnection.talking { auth.await(patience.answer) }
            if (!auth.isSuccess) {
                val isRefused = (auth.isDone && session.isOpen) || auth.exception?.message.orEmpty().contains(REFUSAL)
                session.close(true)
                if (isRefused) return null
                throw IOException("no answer to the login", auth.exception)
            }
            val robot = KeyUtils.getFingerPrint(BuiltinDigests.sha256, shownKey)
            CoreModuleProperties.IDLE_TIMEOUT.set(session, patience.silence)
            return RobotConnection(address, user, robot, session)
        } catch (e: Exception) {
            session.close(true)
            throw e
        }
    }

    /** Returns a session with a trusted host key. */
    private fun open(address: RobotAddress, user: String): ClientSession {
        repeat(2) {
            shownKey = null
            val session = RobotConnection.talking { client.connect(user, address.host, address.port).verify(patience.connect).session }
            val events = setOf(ClientSession.ClientSessionEvent.WAIT_AUTH, ClientSession.ClientSessionEvent.CLOSED)
            val reached = session.waitFor(events, patience.answer)
            if (ClientSession.ClientSessionEvent.WAIT_AUTH in reached && ClientSession.ClientSessionEvent.CLOSED !in reached) return session
            session.close(true)
            if (Thread.interrupted()) throw InterruptedException()
            val key = shownKey ?: throw IOException("no answer")
            val text = PublicKeyEntry.toString(key)
            if (hosts.knows(text)) throw IOException("no answer")
            val question = HostKeyQuestion(address, KeyUtils.getFingerPrint(BuiltinDigests.sha256, key), hosts.hasOther(address))
            if (!acceptsNewKeys && !questions.trusts(question)) throw HostKeyRefusedException(question)
            hosts.trust(address, text)
        }
        throw IOException("the host key changes with each connection")
    }

    override fun close() = client.close(true).let { }
}

/** The maximum number of questions for a password, as in other programs. */
private const val TRIES = 3

/** The library's message when there is no password left to try. */
private const val REFUSAL = "No more authentication methods"
