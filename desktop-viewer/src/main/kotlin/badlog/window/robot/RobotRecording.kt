package badlog.window.robot

import androidx.compose.runtime.snapshotFlow
import badlog.fetch.NetworkTablesSearch
import badlog.fetch.RobotAddress
import badlog.networktables.record.RecordListener
import badlog.networktables.record.RecordOptions
import badlog.networktables.record.RecordProgress
import badlog.networktables.record.RecordedFile
import badlog.networktables.record.Recorder
import badlog.networktables.record.ServerAddress
import badlog.networktables.record.connectedText
import badlog.networktables.record.lostText
import badlog.networktables.record.robotServers
import badlog.viewer.text.bytesText
import badlog.viewer.text.countText
import badlog.window.log.CurrentRecording
import badlog.window.log.LiveView
import badlog.window.log.RecordingLoader
import badlog.window.state.StateHolder
import badlog.window.task.FileWrites
import badlog.window.task.NoticeAction
import badlog.window.task.Notices
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.CoroutineStart
import kotlinx.coroutines.Job
import kotlinx.coroutines.delay
import kotlinx.coroutines.launch
import java.nio.file.Path
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds
import kotlin.time.TimeSource

/**
 * Records the data that a robot publishes on NetworkTables into the window's folder, without code on the robot. Use it only on the window's
 * thread.
 *
 * @param scope the scope of its work; its thread is the window's.
 * @param folder returns the folder for logs; null while no folder is open.
 * @param addressesOf returns the addresses to try for a robot, given the text that a person typed.
 * @param logs shows the recorded logs.
 */
internal class RobotRecording(
    private val scope: CoroutineScope,
    private val notices: Notices,
    private val folder: () -> Path?,
    private val addressesOf: (String) -> List<RobotAddress>,
    private val logs: RecordedLog,
) : StateHolder<RecordingState>(RecordingState()) {
    // Separate from the person's own files, which must not wait for a recorder that waits for its disk.
    private val endings = FileWrites()
    private var running: Running? = null
    private var watching: Job? = null

    /** Reports the folder of the recording when another folder is shown, until cancelled. */
    suspend fun run() = snapshotFlow(folder).collect { shown ->
        val target = running?.target ?: return@collect
        if (shown != target) notices.say("The recording still goes into $target.")
    }

    /** Records [robot], a team's number or an address, until [stop]. With [isPerEnable], writes a log for each time that it is enabled. */
    fun start(robot: String, isPerEnable: Boolean) {
        if (state.isOn) return
        val target = folder() ?: return notices.complain("First open the folder for the robot’s logs.")
        val search = try {
            NetworkTablesSearch(robot.trim(), addressesOf(robot.trim()))
        } catch (e: IllegalArgumentException) {
            return notices.complain(e.message.orEmpty())
        }
        val servers = robotServers(state.isOfAll) { search.find()?.let { ServerAddress(it.host, it.port) } }
        val listener = Listener(servers[0].name)
        val recorder = Recorder(servers, RecordOptions(target, isPerEnable, isRenamed = false), listener)
        running = Running(recorder, listener, target)
        change { RecordingState(true, isPerEnable, isOfAll, "Looking for the robot at ${search.places}.") }
        logs.started()
        recorder.start()
        watching = scope.launch { watch(recorder) }
    }

    /** Ends the recording; its log is finished in the background. */
    fun stop() {
        watching?.cancel()
        end()
    }

    /** Ends the recording, and waits until its log is finished, or only a moment if the disk hangs. Call it before the window closes. */
    fun finish() {
        end()
        endings.finish()
    }

    /** Includes the other servers of a 2027 robot from the next [start] on, or leaves them out. */
    fun toggleAll() = change { copy(isOfAll = !isOfAll) }

    private fun end() {
        val ended = running?.recorder ?: return
        running = null
        change { RecordingState(isOfAll = isOfAll) }
        scope.launch(start = CoroutineStart.UNDISPATCHED) { endings.write(ended::close) }
    }

    private suspend fun watch(recorder: Recorder) {
        while (true) {
            val progress = recorder.progress
            if (progress.file != state.file) {
                change { copy(file = progress.file) }
                progress.file?.let(logs::begun)
            }
            change { copy(amount = amountOf(progress)) }
            recorder.failure?.let { failure ->
                end()
                return notices.complain(failure)
            }
            delay(PERIOD)
        }
    }

    private fun amountOf(progress: RecordProgress): String {
        val file = progress.file ?: return ""
        return "${file.fileName}: ${countText(progress.topics, "topic")}, ${bytesText(progress.bytes.toDouble())}"
    }

    private class Running(val recorder: Recorder, val listener: RecordListener, val target: Path)

    /** Reports the recorder's events on the window's thread; of the connections, only the one to the [robot]. */
    private inner class Listener(private val robot: String) : RecordListener {
        override fun connected(name: String, address: ServerAddress) = say(name, connectedText(name, address))

        override fun disconnected(name: String, reason: String) = say(name, lostText(name, reason))

        override fun noted(message: String) {
            scope.launch { notices.complain(message) }
        }

        override fun finished(file: RecordedFile) {
            val gaps = if (file.gaps > 0) "; lost connections: ${countText(file.gaps)}" else ""
            val lost = if (file.dropped > 0) "; values missing, because the disk was too slow: ${file.dropped}" else ""
            val text = "${file.path.fileName} is recorded: ${countText(
                file.topics,
                "topic",
            )}, ${bytesText(file.bytes.toDouble())}$gaps$lost."
            scope.launch { if (file.dropped > 0) notices.complain(text) else notices.say(text) }
        }

        private fun say(name: String, text: String) {
            if (name == robot) scope.launch { if (running?.listener === this@Listener) change { copy(connection = text) } }
        }
    }

    private companion object {
        val PERIOD = 100.milliseconds
    }
}

/**
 * A recording of the data that a robot publishes, as the window shows it.
 *
 * @property isOn whether the window is recording.
 * @property isPerEnable whether each time that the robot is enabled gets a log of its own.
 * @property isOfAll whether the other servers of a 2027 robot and of its Driver Station are also recorded.
 * @property connection the state of the connection to the robot, as a sentence.
 * @property file the log that is being written; null for none.
 * @property amount the amount of data in the log; empty without a log.
 */
internal data class RecordingState(
    val isOn: Boolean = false,
    val isPerEnable: Boolean = false,
    val isOfAll: Boolean = false,
    val connection: String = "",
    val file: Path? = null,
    val amount: String = "",
) {
    /** The condition for which the recording waits, as a sentence; null while a log is being written. */
    val waiting: String?
        get() = when {
            file != null -> null
            isPerEnable -> "A log begins when the robot is enabled."
            else -> "A log begins when the robot answers."
        }
}

/**
 * Shows the log that the window records, unless a person looks at another one. Use it only on the window's thread.
 *
 * @param isWriting returns whether a person is writing something that belongs to the open log.
 */
internal class RecordedLog(
    private val current: CurrentRecording,
    private val live: LiveView,
    private val loader: RecordingLoader,
    private val notices: Notices,
    private val isWriting: () -> Boolean,
) {
    private var askedSince: TimeSource.Monotonic.ValueTimeMark? = null
    private var openBefore: Path? = null

    /** Remembers the open log when a person begins to record, and that the person expects to see the recording soon. */
    fun started() {
        openBefore = current.recording?.file
        askedSince = TimeSource.Monotonic.markNow()
    }

    /** Shows [log], which is now being recorded, at its newest moment, or offers to show it. */
    fun begun(log: Path) {
        val open = current.recording?.file
        val isJustAsked = open == openBefore && askedSince?.let { it.elapsedNow() < PATIENCE } == true
        askedSince = null
        val isFree = !loader.isReading && !isWriting() && (open == null || isJustAsked || live.isUntouched)
        if (isFree) show(log) else notices.say("${log.fileName} is being recorded.", NoticeAction("Show") { show(log) })
    }

    private fun show(log: Path) {
        live.await(log)
        loader.open(log)
    }

    private companion object {
        /** The time after which a person is assumed to be doing something else. */
        val PATIENCE = 10.seconds
    }
}
