package badlog.fetch

import badlog.files.UnreadableFileException
import badlog.files.UnwritableFileException
import java.io.IOException

/**
 * Fetches new logs from a robot to the folder of [options].
 *
 * Logs are copied while the robot is disabled. Each is a hidden part until it is complete, and the next fetch continues an existing part.
 * Nothing is removed from the robot unless the options say so.
 *
 * @param addresses the addresses at which the robot may answer, the most likely first.
 * @property options the options of the fetch.
 * @param hosts the robots that are trusted.
 * @param stateOf connects to a robot's NetworkTables and returns its enabled state.
 */
class LogFetch internal constructor(
    private val addresses: List<RobotAddress>,
    val options: FetchOptions,
    private val hosts: KnownHosts,
    private val questions: FetchQuestions,
    private val patience: Patience,
    private val stateOf: (RobotAddress) -> RobotState,
) {
    constructor(
        addresses: List<RobotAddress>,
        options: FetchOptions,
        hosts: KnownHosts,
        questions: FetchQuestions = FetchQuestions.NOBODY,
        patience: Patience = Patience(),
    ) : this(addresses, options, hosts, questions, patience, { RobotState(it, patience.state) })

    /**
     * Fetches once. Blocks until everything is done; interrupting the thread ends it.
     *
     * @throws FetchException if logs cannot be fetched from the robot.
     * @throws badlog.files.UnwritableFileException if the folder cannot be written to.
     * @throws InterruptedException if the thread was interrupted.
     */
    fun run(listener: FetchListener): FetchSummary = FetchedLogs.open(options.folder).use { here ->
        RobotLogin(hosts, questions, options.acceptsNewHostKeys, options.password, patience).use { login ->
            Visit(login, here, listener).use(Visit::run)
        }
    }

    /** One fetch, which may take several connections. */
    private inner class Visit(private val login: RobotLogin, private val here: FetchedLogs, private val listener: FetchListener) :
        AutoCloseable {
        private var state: RobotState? = null
        private var connection: RobotConnection? = null
        private val transfer = Transfer(options, here, listener, patience) { if (state?.isEnabled == true) throw EnabledRobotException() }

        fun run(): FetchSummary {
            val address = enter()
            val user = connection!!.user
            listener.connected(address, user)
            var failures = 0
            while (true) {
                val before = transfer.received
                try {
                    val robot = connection ?: login.into(address).also { connection = it }
                    transfer.run(robot)
                    return FetchSummary(address, user, transfer.fetched, transfer.known)
                } catch (_: EnabledRobotException) {
                    leave()
                    awaitDisabled(address)
                } catch (_: UnknownStateException) {
                    // Its program may be restarting; otherwise its state is unknown.
                    leave()
                    state?.close()
                    watch(address)
                } catch (e: IOException) {
                    if (RobotConnection.isInterruption(e)) throw InterruptedException()
                    if (e.isOfThisComputer) throw e
                    leave()
                    failures = if (transfer.received > before) 1 else failures + 1
                    val reason = reasonOf(e)
                    if (failures >= TRIES) throw LostConnectionException(address, reason, e)
                    listener.retrying(address, reason)
                    Thread.sleep(patience.retry.toMillis())
                }
            }
        }

        /** Connects to the first address at which a user is accepted. */
        private fun enter(): RobotAddress {
            var reason: Exception? = null
            for (address in answering(addresses, patience.connect)) {
                try {
                    watch(address)
                    connection = login.into(address)
                    return address
                } catch (e: LoginRefusedException) {
                    reason = reason ?: e
                } catch (e: IOException) {
                    if (RobotConnection.isInterruption(e)) throw InterruptedException()
                    if (e.isOfThisComputer) throw e
                    reason = reason ?: LostConnectionException(address, reasonOf(e), e)
                }
                state?.close()
            }
            throw reason ?: NoRobotException(addresses)
        }

        private fun watch(address: RobotAddress) {
            if (options.anyway) return
            state = stateOf(address)
            awaitDisabled(address)
        }

        private fun awaitDisabled(address: RobotAddress) {
            val state = state ?: return
            if (!state.isEnabled) return
            listener.waiting(address)
            state.awaitDisabled()
        }

        private fun leave() {
            connection?.close()
            connection = null
        }

        override fun close() {
            leave()
            state?.close()
        }
    }
}

/** Thrown if the robot was enabled while logs were being copied. */
internal class EnabledRobotException : Exception()

/** Whether the problem is a file on this computer, not the network. */
private val IOException.isOfThisComputer: Boolean get() = this is UnreadableFileException || this is UnwritableFileException

private fun reasonOf(e: IOException): String = (e.message ?: e.cause?.message)?.lineSequence()?.first()?.let(::safeReason) ?: "no answer"

/** Returns [text] without control characters and shortened, because a robot's message may contain anything. */
private fun safeReason(text: String) = text.filter { !it.isISOControl() }.take(MAX_REASON)

private const val MAX_REASON = 100

/** The number of connections in succession that may be lost without a byte transferred. */
private const val TRIES = 3
