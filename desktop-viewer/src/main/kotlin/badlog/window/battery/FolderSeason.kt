package badlog.window.battery

import androidx.compose.runtime.snapshotFlow
import badlog.catalog.folder.FolderBatteries
import badlog.catalog.folder.LogEntry
import badlog.viewer.shown.battery.BatteryAdvice
import badlog.viewer.shown.battery.BatteryMatch
import badlog.viewer.shown.battery.BatterySeason
import badlog.window.folder.Library
import badlog.window.state.StateHolder
import badlog.window.task.Notices
import badlog.window.task.assertOffWindow
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.flow.MutableStateFlow
import kotlinx.coroutines.flow.collectLatest
import kotlinx.coroutines.flow.combine
import kotlinx.coroutines.flow.filterNotNull
import kotlinx.coroutines.launch
import kotlinx.coroutines.withContext
import java.nio.file.Path

/**
 * The batteries of the folder's logs.
 *
 * @property seasons each battery with its matches.
 * @property advice the advice on the batteries.
 * @property problems the reasons why a file about batteries is not used, as sentences.
 */
internal class Batteries(
    val seasons: List<BatterySeason> = emptyList(),
    val advice: BatteryAdvice = BatteryAdvice.of(seasons),
    val problems: List<String> = emptyList(),
) {
    /** The team's names for its batteries. */
    val names: List<String> get() = seasons.mapNotNull { it.battery?.name }

    companion object {
        /** Returns the batteries in [logs] of [folder]. Reads files: call it off the window's thread. */
        fun of(logs: List<LogEntry>, folder: Path?): Batteries {
            assertOffWindow()
            val written = FolderBatteries.of(logs.map { it.file }, folder)
            val seasons = BatterySeason.of(logs, written.batteries) { entries ->
                written.usedFor(entries.map { it.file }, matchOf(entries))
            }
            return Batteries(seasons, BatteryAdvice.of(seasons), written.problems)
        }
    }
}

/**
 * Follows the batteries of the folder's logs and the team's records of them, while they are shown. Use it only on the window's thread.
 *
 * @param isShown returns whether a person sees the batteries.
 */
internal class FolderSeason(
    private val scope: CoroutineScope,
    private val library: Library,
    private val notices: Notices,
    private val isShown: () -> Boolean,
) : StateHolder<Batteries>(Batteries()) {
    private val written = MutableStateFlow(0)

    /** Follows the folder, until cancelled. */
    suspend fun run() {
        val logs = snapshotFlow { if (isShown()) library.state.entries to library.state.folder else null }
        combine(logs, written) { shown, _ -> shown }.filterNotNull().collectLatest { (entries, folder) ->
            val found = withContext(Dispatchers.IO) { Batteries.of(entries, folder) }
            change { found }
        }
    }

    /** Reads the team's records again. */
    fun refresh() {
        written.value++
    }

    /** Records, beside the logs of [match], that the robot had the battery called [name]. An empty name removes the record. */
    fun assign(name: String, match: BatteryMatch) {
        val logs = library.state.entries.filter { it.path in match.paths }.sortedBy { match.paths.indexOf(it.path) }
        if (logs.isEmpty()) return
        val folder = library.state.folder
        val known = state.names.find { it.equals(name.trim(), ignoreCase = true) } ?: name.trim()
        scope.launch {
            val problem = withContext(Dispatchers.IO) { FolderBatteries.assign(known, logs.map { it.file }, matchOf(logs), folder) }
            problem?.let(notices::complain)
            refresh()
        }
    }
}

private fun matchOf(logs: List<LogEntry>) = logs.firstNotNullOfOrNull { it.summary.match.match }
