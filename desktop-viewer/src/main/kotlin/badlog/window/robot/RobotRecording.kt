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
import badlog.window.state.StateHolder
import badlog.window.task.FileWrites
import badlog.window.task.Notices
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.CoroutineStart
import kotlinx.coroutines.Job
import kotlinx.coroutines.delay
import kotlinx.coroutines.launch
import java.nio.file.Path
import kotlin.time.Duration.Companion.milliseconds

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
