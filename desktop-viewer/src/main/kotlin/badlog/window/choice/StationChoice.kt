package badlog.window.choice

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.FlowRow
import androidx.compose.foundation.layout.fillMaxWidth
import androidx.compose.foundation.layout.padding
import androidx.compose.material3.Text
import androidx.compose.runtime.Composable
import androidx.compose.runtime.snapshotFlow
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import badlog.catalog.match.MatchMaker
import badlog.files.LogFile
import badlog.files.LogName
import badlog.files.readStationLog
import badlog.files.startOfStationLog
import badlog.files.stationFolders
import badlog.files.stationLogsIn
import badlog.formats.LOG_FORMATS
import badlog.formats.driverstation.STATION_HEAD_SIZE
import badlog.formats.driverstation.isOfDriverStation
import badlog.formats.driverstation.stationStartIn
import badlog.rules.folder.FolderRules
import badlog.signals.clock.ClockFit
import badlog.signals.clock.ClockedLog
import badlog.signals.clock.FoundStation
import badlog.signals.clock.StationSearch
import badlog.viewer.text.numberText
import badlog.window.log.CurrentRecording
import badlog.window.log.OpenRecording
import badlog.window.settings.SettingsStore
import badlog.window.state.StateHolder
import badlog.window.theme.LocalPalette
import badlog.window.theme.ToolButton
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.flow.collectLatest
import kotlinx.coroutines.runInterruptible
import java.io.IOException
import java.nio.file.Path
import kotlin.math.ceil

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

/**
 * Returns the Driver Station's log of the same match as [robot]; null if none can be identified. It may be in the folder of [robot], in the
 * folder of logs [library], or where the Driver Station of this computer keeps its logs. Interrupting the thread cancels.
 */
internal fun stationBeside(robot: OpenRecording, library: Path?): FoundStation<LogFile>? {
    // A ZIP has the files of its match.
    if (isMatch(robot.file)) return null
    val clocked = ClockedLog(robot.file.fileName.toString(), robot.view.recording, robot.vocabulary)
    if (!clocked.hasClock) return null
    val logs = (listOfNotNull(robot.file.parent, library) + stationFolders()).distinct().flatMap(::logsIn).distinctBy { it.path }
    return StationSearch(clocked, ::startOf) { clockedLog(it, library) }.over(logs, mostRead = MAX_READ)
}

private fun isMatch(file: Path): Boolean = try {
    MatchMaker.isSource(file)
} catch (_: IOException) {
    // It was removed.
    false
}

private fun logsIn(folder: Path): List<LogFile> = try {
    stationLogsIn(folder, ::checkInterrupt)
} catch (_: IOException) {
    emptyList()
}

private fun clockedLog(log: LogFile, library: Path?): ClockedLog? {
    checkInterrupt()
    return readStationLog(log, LOG_FORMATS)?.let { ClockedLog(log.name, it, FolderRules.of(log.path, library).rules.signals) }
}

private fun startOf(log: LogFile): Double? = startOfStationLog(log, STATION_HEAD_SIZE, ::stationStartIn)

private fun checkInterrupt() {
    if (Thread.interrupted()) throw InterruptedException()
}

/** The largest number of logs to read. More than a team plays in a day would take too much time and memory. */
private const val MAX_READ = 40

/** Offers the Driver Station's log of the same match until a person shows or hides it. While that log is shown, it says so. */
@Composable
internal fun StationOffer(stations: StationChoice) {
    val offered = stations.offered
    val found = offered ?: stations.found?.takeIf { stations.isShown } ?: return
    val name = LogName.of(found.log.name).stem
    val palette = LocalPalette.current
    FlowRow(
        Modifier.fillMaxWidth().background(if (offered == null) palette.surface else palette.accentSoft).padding(start = 12.dp, end = 4.dp),
        itemVerticalAlignment = Alignment.CenterVertically,
    ) {
        val how = alignmentText(found.fit)
        val text = if (offered == null) "With the Driver Station log $name ($how)." else "Driver Station log found: $name ($how)."
        Text(text, Modifier.padding(end = 8.dp, top = 4.dp, bottom = 4.dp), color = if (offered == null) palette.muted else palette.text)
        if (offered == null) {
            ToolButton("Hide the Driver Station log; the menu Layout can show it again", text = "Hide") { stations.choose(false) }
        } else {
            ToolButton("Show its link, power and messages with this log, and use them in rules", text = "Show") { stations.choose(true) }
            ToolButton("Hide it; the menu Layout can show it", text = "Hide") { stations.choose(false) }
        }
    }
}

/** Returns the precision of an alignment: `± 0.02 s`. */
internal fun alignmentText(fit: ClockFit): String {
    // The Driver Station logs every 20 ms: a better precision is impossible.
    val error = ceil(maxOf(fit.error, PERIOD) * HUNDRED) / HUNDRED
    return "± ${numberText(error)} s" + if (fit.edges == 0) ", aligned by the clocks only" else ""
}

private const val PERIOD = 0.02
private const val HUNDRED = 100
