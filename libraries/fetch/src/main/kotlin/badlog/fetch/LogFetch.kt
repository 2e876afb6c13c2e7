package badlog.fetch

import badlog.file.UnreadableFileException
import badlog.file.UnwritableFileException
import java.io.IOException

/**
 * Fetches the logs that are new from a robot, to the folder of [options].
 *
 * A log comes while the robot is disabled; it is a hidden part until it is whole, and the next fetch goes on with a part that is left.
 * Nothing is removed from the robot unless the options say so.
 *
 * @param addresses where the robot may answer, the likeliest first.
 * @property options what to fetch, and how.
 * @param hosts the robots that are trusted.
 */
public class LogFetch(
    private val addresses: List<RobotAddress>,
    public val options: FetchOptions,
    private val hosts: KnownHosts,
    private val questions: FetchQuestions = FetchQuestions.NOBODY,
    private val patience: Patience = Patience(),
) {
    /**
     * Fetches once. Blocks until all is done; an interruption of the thread ends it.
     *
     * @throws FetchException when the robot cannot be fetched from.
     * @throws badlog.file.UnwritableFileException when the folder cannot be written to.
     * @throws InterruptedException when the thread was interrupted.
     */
    public fun run(listener: FetchListener): FetchSummary = FetchedLogs.open(options.folder).use { here ->
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
                    // Its program starts anew; if it does not, nobody knows.
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

        /** Connects to the first address at which somebody is let in. */
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
            state = RobotState(address, patience.state)
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

    private companion object {
        /** So often a connection may be lost one after another, without a byte between. */
        const val TRIES = 3
    }
}

/** The robot was enabled while logs came. */
internal class EnabledRobotException : Exception()

/** Whether the network has no part in it. */
private val IOException.isOfThisComputer: Boolean get() = this is UnreadableFileException || this is UnwritableFileException

private fun reasonOf(e: IOException): String = (e.message ?: e.cause?.message)?.lineSequence()?.first()?.let(::safeReason) ?: "no answer"

/** What a robot said is text of anybody's. */
private fun safeReason(text: String) = text.filter { !it.isISOControl() }.take(MAX_REASON)

private const val MAX_REASON = 100
