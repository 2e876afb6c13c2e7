package badlog.window.robot

import badlog.fetch.NetworkTablesSearch
import badlog.fetch.RobotAddress
import badlog.record.RecordListener
import badlog.record.RecordOptions
import badlog.record.RecordProgress
import badlog.record.RecordedFile
import badlog.record.Recorder
import badlog.record.ServerAddress
import badlog.record.robotServers
import badlog.viewer.text.bytesText
import badlog.viewer.text.countText
import badlog.window.state.StateHolder
import badlog.window.task.FileWrites
import badlog.window.task.Notices
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Job
import kotlinx.coroutines.delay
import kotlinx.coroutines.launch
import java.nio.file.Path
import kotlin.time.Duration.Companion.milliseconds

/**
 * Records what a robot publishes on NetworkTables into the folder that the window shows, without code on the robot. Use it only on the
 * window's thread.
 *
 * @param scope where it works; its thread is the window's.
 * @param folder where logs go; null while no folder is open.
 * @param addressesOf where the robot that a person typed may answer.
 * @param logs shows them.
 */
internal class RobotRecording(
    private val scope: CoroutineScope,
    private val notices: Notices,
    private val writes: FileWrites,
    private val folder: () -> Path?,
    private val addressesOf: (String) -> List<RobotAddress>,
    private val logs: RecordedLog,
) : StateHolder<RecordingState>(RecordingState()) {
    private var recorder: Recorder? = null
    private var watching: Job? = null

    /** Records [robot], a team's number or an address, until [stop]; [isPerEnable] for a log each time that it is enabled. */
    fun start(robot: String, isPerEnable: Boolean) {
        if (state.isOn) return
        val target = folder() ?: return notices.complain("First open the folder for the robot’s logs.")
        val search = try {
            NetworkTablesSearch(robot.trim(), addressesOf(robot.trim()))
        } catch (e: IllegalArgumentException) {
            return notices.complain(e.message.orEmpty())
        }
        val options = RecordOptions(target, isPerEnable, isRenamed = false)
        val servers = robotServers(state.isOfAll) { search.find()?.let { ServerAddress(it.host, it.port) } }
        val begun = Recorder(servers, options, Listener())
        recorder = begun
        change { copy(isOn = true, isPerEnable = isPerEnable, connection = "Looking for the robot at ${search.places}.", amount = "") }
        logs.started()
        begun.start()
        watching = scope.launch { watch(begun) }
    }

    /** Ends the recording; its log is finished in the background. */
    fun stop() {
        val ended = recorder ?: return
        recorder = null
        watching?.cancel()
        change { copy(isOn = false, connection = "", amount = "") }
        scope.launch { writes.write(ended::close) }
    }

    /** Ends the recording and waits until its log is finished, as before the window closes. */
    fun finish() {
        recorder?.close()
        recorder = null
    }

    /** Records the servers of 2027 besides from the next [start] on, or no longer. */
    fun toggleAll() = change { copy(isOfAll = !isOfAll) }

    private suspend fun watch(recorder: Recorder) {
        var file: Path? = null
        while (true) {
            val progress = recorder.progress
            if (progress.file != file) {
                file = progress.file
                file?.let { logs.begun(it, state.isPerEnable) }
            }
            change { copy(amount = amountOf(progress)) }
            recorder.failure?.let { failure ->
                stop()
                return notices.complain(failure)
            }
            delay(PERIOD)
        }
    }

    private fun amountOf(progress: RecordProgress): String {
        val file = progress.file ?: return ""
        return "${file.fileName}: ${countText(progress.topics, "topic")}, ${bytesText(progress.bytes.toDouble())}"
    }

    /** Reports on the window's thread what happens on the recorder's. */
    private inner class Listener : RecordListener {
        override fun connected(name: String, address: ServerAddress) = say("Connected to the $name at $address.")

        override fun disconnected(name: String, reason: String) = say("The connection to the $name was lost ($reason); looking for it.")

        override fun noted(message: String) {
            scope.launch { notices.say(message) }
        }

        override fun finished(file: RecordedFile) {
            val lost = "; ${countText(file.dropped.toInt(), "value")} missing, because the disk was too slow".takeIf { file.dropped > 0 }.orEmpty()
            val gaps = "; the connection was lost ${countText(file.gaps, "time")}".takeIf { file.gaps > 0 }.orEmpty()
            val text = "${file.path.fileName} is recorded: ${countText(file.values.toInt(), "value")} of ${countText(file.topics, "topic")}$gaps$lost."
            scope.launch { if (file.dropped > 0) notices.complain(text) else notices.say(text) }
        }

        private fun say(text: String) {
            scope.launch { change { if (isOn) copy(connection = text) else this } }
        }
    }

    private companion object {
        val PERIOD = 100.milliseconds
    }
}
