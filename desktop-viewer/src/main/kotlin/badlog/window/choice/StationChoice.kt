package badlog.window.choice

import androidx.compose.runtime.snapshotFlow
import badlog.files.LogFile
import badlog.formats.driverstation.isOfDriverStation
import badlog.signals.clock.FoundStation
import badlog.window.log.CurrentRecording
import badlog.window.log.OpenRecording
import badlog.window.settings.SettingsStore
import badlog.window.state.StateHolder
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.flow.collectLatest
import kotlinx.coroutines.runInterruptible
import java.nio.file.Path

/**
 * The Driver Station's log of the same match as [robot].
 *
 * @property robot an opened log; null before one was opened.
 * @property found the Driver Station's log; null while none is known.
 */
internal data class StationOfLog(val robot: Path? = null, val found: FoundStation<LogFile>? = null)

/**
 * Finds the Driver Station's log of the current recording's match, and shows both together if a person wants it. The choice is remembered
 * for each log. Use it only on the window's thread.
 *
 * @param folder returns the folder of logs.
 * @param find finds the Driver Station's log, off the window's thread.
 */
internal class StationChoice(
    private val current: CurrentRecording,
    private val settings: SettingsStore,
    private val folder: () -> Path?,
    private val find: (OpenRecording, Path?) -> FoundStation<LogFile>? = ::stationBeside,
) : StateHolder<StationOfLog>(StationOfLog()) {
    /** The Driver Station's log that belongs to the current recording; null if none is known. */
    val found: FoundStation<LogFile>? get() = state.found.takeIf { state.robot == current.recording?.file }

    /** The Driver Station's log to offer, which the user has neither shown nor dismissed; null if there is none. */
    val offered: FoundStation<LogFile>? get() = found?.takeIf { state.robot.toString() !in settings.state.stations }

    /** Whether the Driver Station's log is shown. */
    val isShown: Boolean get() = current.recording?.station != null

    /** Searches for the Driver Station's log of each opened log, until cancelled. */
    suspend fun run() = snapshotFlow { current.recording?.file to folder() }.collectLatest { (file, folder) ->
        if (state.robot != file) change { StationOfLog(file) }
        val open = current.recording?.takeIf { it.file == file } ?: return@collectLatest
        // A Driver Station's log needs no other one.
        if (open.view.recording.isOfDriverStation) return@collectLatest
        val found = runInterruptible(Dispatchers.IO) { find(open.with(open.choices.copy(station = null)), folder) }
        change { StationOfLog(file, found) }
    }

    /** Shows the Driver Station's log with the current recording from now on, or hides it. */
    fun choose(isShown: Boolean) {
        val file = current.recording?.file ?: return
        settings.change { withStation(file.toString(), isShown) }
    }

    /** Returns the Driver Station's log that is shown with the log in [file]; null for none. */
    fun shownWith(file: Path): FoundStation<LogFile>? =
        state.found.takeIf { file == state.robot && settings.state.stations[file.toString()] == true }
}
