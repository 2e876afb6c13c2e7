package badlog.window.robot

import androidx.compose.runtime.snapshotFlow
import badlog.fetch.FetchException
import badlog.fetch.FetchListener
import badlog.fetch.FetchOptions
import badlog.fetch.FetchQuestions
import badlog.fetch.FetchSummary
import badlog.fetch.FetchedLog
import badlog.fetch.FoundLogs
import badlog.fetch.HostKeyQuestion
import badlog.fetch.HostKeyRefusedException
import badlog.fetch.KnownHosts
import badlog.fetch.LogFetch
import badlog.fetch.LoginRefusedException
import badlog.fetch.RobotAddress
import badlog.fetch.UnknownStateException
import badlog.window.state.StateHolder
import badlog.window.task.NoticeAction
import badlog.window.task.Notices
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.Job
import kotlinx.coroutines.delay
import kotlinx.coroutines.launch
import kotlinx.coroutines.runInterruptible
import java.io.IOException
import java.nio.file.Path
import java.util.concurrent.ArrayBlockingQueue
import java.util.concurrent.atomic.AtomicInteger
import kotlin.time.Duration.Companion.seconds

/**
 * Copies the logs of a robot to the window's folder, as they are created and while the robot is disabled. Use it only on the window's
 * thread.
 *
 * @param scope the scope of its work; its thread is the window's.
 * @param folder returns the folder for logs; null while no folder is open.
 * @param show shows a log.
 * @param addressesOf returns the addresses to try for a robot, given the text that a person typed.
 */
internal class RobotLink(
    private val scope: CoroutineScope,
    private val hosts: KnownHosts,
    private val notices: Notices,
    private val folder: () -> Path?,
    private val show: (Path) -> Unit,
    private val addressesOf: (String) -> List<RobotAddress>,
) : StateHolder<RobotLinkState>(RobotLinkState()) {
    private var job: Job? = null
    private var fetching: Fetching? = null

    /** Reports the folder for the robot's logs when another folder is shown, until cancelled. */
    suspend fun run() = snapshotFlow(folder).collect { shown ->
        val now = fetching?.takeIf { state.isOn } ?: return@collect
        if (shown == null || shown == now.target) return@collect
        notices.say("The robot’s logs still go into ${now.target}.", NoticeAction("Fetch into this folder") { connect(now.robot) })
    }

    /**
     * Looks for [robot], a team's number or an address, and fetches from it until [disconnect]. With [anyway], it fetches even if the robot
     * may be enabled.
     */
    fun connect(robot: String, anyway: Boolean = false) {
        val before = job
        disconnect()
        val target = folder() ?: return change { saying("First open the folder for the robot’s logs.", isTrouble = true) }
        val addresses = try {
            addressesOf(robot.trim())
        } catch (e: IllegalArgumentException) {
            return change { saying(e.message.orEmpty(), isTrouble = true) }
        }
        fetching = Fetching(robot, target)
        change { saying("Looking for the robot…").copy(isOn = true) }
        job = scope.launch {
            // Two fetches at a time would interfere with each other.
            before?.join()
            val fetch = LogFetch(addresses, FetchOptions(target, anyway = anyway), hosts, Questions())
            while (true) {
                val goesOn = once(fetch)
                if (!goesOn) break
                delay(PERIOD)
            }
            change { copy(isOn = false) }
        }
    }

    /** Disconnects; the copied part of a log is kept for the next time. */
    fun disconnect() {
        job?.cancel()
        job = null
        change { saying("").copy(isOn = false) }
    }

    /** Fetches new logs. Returns whether to check again. */
    private suspend fun once(fetch: LogFetch): Boolean {
        try {
            val summary = runInterruptible(Dispatchers.IO) { fetch.run(Listener()) }
            if (summary.fetched.isNotEmpty()) announce(summary)
            val count = summary.known + summary.fetched.size
            change { saying("Connected to ${summary.address}: nothing new, ${logs(count)} fetched.") }
        } catch (e: HostKeyRefusedException) {
            change { saying("${e.address} is not trusted, so nothing was fetched.", isTrouble = true) }
            return false
        } catch (e: LoginRefusedException) {
            change { saying("${e.address} refuses the password; connect again to type another one.", isTrouble = true) }
            return false
        } catch (e: UnknownStateException) {
            val status = "${e.address} does not say whether it is enabled; start its program."
            change { saying(status, isTrouble = true).copy(mayBeEnabled = true) }
        } catch (e: FetchException) {
            change { saying(e.message, isTrouble = true) }
        } catch (e: IOException) {
            change { saying(e.message.orEmpty(), isTrouble = true) }
            return false
        }
        return true
    }

    private fun announce(summary: FetchSummary) {
        val newest = summary.fetched.firstOrNull { it.isLog } ?: return
        val title = newest.title ?: newest.file.fileName.toString()
        val text = if (summary.fetched.size == 1) {
            "$title came from ${summary.address}."
        } else {
            "${logs(summary.fetched.size)} came from ${summary.address}, the newest is $title."
        }
        notices.say(text, NoticeAction("Show") { show(newest.file) })
    }

    private fun logs(count: Int) = if (count == 1) "1 log" else "$count logs"

    /** A fetch of the logs of [robot], as a person typed it, into [target]. */
    private class Fetching(val robot: String, val target: Path)

    /** Reports the events of another thread on the window's thread. */
    private inner class Listener : FetchListener {
        private val percent = AtomicInteger(-1)
        private var left = 0

        override fun connected(address: RobotAddress, user: String) = say { saying("Connected to $address as $user.") }

        override fun waiting(address: RobotAddress) = say { saying("$address is enabled; its logs are copied when it is disabled.") }

        override fun retrying(address: RobotAddress, reason: String) = say { saying("The connection to $address was lost; trying again.") }

        override fun found(logs: FoundLogs) {
            left = logs.newLogs
            if (left > 0) say { saying("${if (left == 1) "1 new log" else "$left new logs"} on the robot.") }
        }

        override fun advanced(name: String, done: Long, total: Long) {
            val now = if (total > 0) (done * PERCENT / total).toInt() else PERCENT
            if (percent.getAndSet(now) != now) say { copy(coming = ComingLog(name, now / PERCENT.toFloat())) }
        }

        override fun fetched(log: FetchedLog) {
            left--
            say { copy(coming = null) }
        }

        private fun say(transition: RobotLinkState.() -> RobotLinkState) {
            val mine = job
            scope.launch { if (mine == null || mine.isActive) change { if (isOn) transition() else this } }
        }
    }

    /** Asks on the window's thread, and waits for the answer on the other one. */
    private inner class Questions : FetchQuestions {
        override fun trusts(question: HostKeyQuestion): Boolean {
            val what = if (question.isChanged) {
                "The robot at ${question.address} has a new key: it was re-imaged, or another robot uses this address."
            } else {
                "The robot at ${question.address} is unknown."
            }
            return ask("$what Its key is ${question.fingerprint}. Trust it?", isPassword = false) != null
        }

        override fun password(user: String, address: RobotAddress): String? = ask("Password of $user at $address", isPassword = true)

        private fun ask(text: String, isPassword: Boolean): String? {
            val answers = ArrayBlockingQueue<List<String>>(1)
            val question = RobotQuestion(text, isPassword) { answer ->
                change { copy(question = null) }
                answers.offer(listOfNotNull(answer))
            }
            scope.launch { change { if (isOn) copy(question = question) else this } }
            return answers.take().firstOrNull()
        }
    }

    private companion object {
        val PERIOD = 5.seconds
        const val PERCENT = 100
    }
}

/**
 * A question to the person at the window before logs can be fetched.
 *
 * @property text the question.
 * @property isPassword whether the answer is a password; otherwise it is yes or no.
 * @property answer receives the answer; null for no.
 */
internal class RobotQuestion(val text: String, val isPassword: Boolean, val answer: (String?) -> Unit)

/**
 * A log being copied.
 *
 * @property name its name on the robot.
 * @property share the copied fraction, 0 to 1.
 */
internal data class ComingLog(val name: String, val share: Float)

/**
 * The connection to a robot, as the window shows it.
 *
 * @property isShown whether the connection is shown.
 * @property isAsked whether the field of the robot's number gets the keyboard focus as soon as it is visible.
 * @property isOn whether the window repeatedly looks for the robot.
 * @property status the status, as a sentence; empty before the first attempt.
 * @property isTrouble whether the status prevents fetching.
 * @property mayBeEnabled whether fetching waits because it is unknown whether the robot is enabled.
 * @property coming the log being copied, or null.
 * @property question the question to the person, or null.
 */
internal data class RobotLinkState(
    val isShown: Boolean = false,
    val isAsked: Boolean = false,
    val isOn: Boolean = false,
    val status: String = "",
    val isTrouble: Boolean = false,
    val mayBeEnabled: Boolean = false,
    val coming: ComingLog? = null,
    val question: RobotQuestion? = null,
) {
    /** Shows the connection, with the keyboard focus in the field of the robot's number. */
    fun shown(): RobotLinkState = copy(isShown = true, isAsked = true)

    /** Shows the connection, or hides it. */
    fun toggled(): RobotLinkState = if (isShown) copy(isShown = false, isAsked = false) else shown()

    /** Returns the state with only a new [status]. */
    fun saying(status: String, isTrouble: Boolean = false): RobotLinkState =
        copy(status = status, isTrouble = isTrouble, mayBeEnabled = false, coming = null, question = null)
}
