package badlog.window.battery

import androidx.compose.runtime.snapshotFlow
import badlog.catalog.folder.FolderBatteries
import badlog.catalog.folder.LogEntry
import badlog.viewer.shown.battery.BatteryAdvice
import badlog.viewer.shown.battery.BatterySeason
import badlog.window.folder.Library
import badlog.window.log.assertOffWindow
import badlog.window.state.StateHolder
import badlog.window.task.Notices
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.flow.MutableStateFlow
import kotlinx.coroutines.flow.collectLatest
import kotlinx.coroutines.flow.combine
import kotlinx.coroutines.launch
import kotlinx.coroutines.withContext
import java.nio.file.Path

/**
 * The batteries of the folder's logs.
 *
 * @property seasons what is known of each.
 * @property advice what to do with them.
 * @property problems why a file about batteries is not used, as sentences.
 */
internal class Batteries(
    val seasons: List<BatterySeason> = emptyList(),
    val advice: BatteryAdvice = BatteryAdvice.of(seasons),
    val problems: List<String> = emptyList(),
) {
    /** The names that the team uses. */
    val names: List<String> get() = seasons.mapNotNull { it.battery?.name }

    companion object {
        /** Returns the batteries in [logs] of [folder]; it reads files. */
        fun of(logs: List<LogEntry>, folder: Path?): Batteries {
            assertOffWindow()
            val written = FolderBatteries.of(logs.map { it.file }, folder)
            val seasons = BatterySeason.of(logs, written.batteries) { written.usedFor(it.file, it.summary.match.match) }
            return Batteries(seasons, BatteryAdvice.of(seasons), written.problems)
        }
    }
}

/** Follows what the folder's logs say of its batteries, and what the team writes down. Use it only on the window's thread. */
internal class FolderSeason(private val scope: CoroutineScope, private val library: Library, private val notices: Notices) :
    StateHolder<Batteries>(Batteries()) {
    private val written = MutableStateFlow(0)

    /** Follows the folder, until cancelled. */
    suspend fun run() {
        combine(
            snapshotFlow {
                library.state.entries to library.state.folder
            },
            written,
        ) { logs, _ -> logs }.collectLatest { (logs, folder) ->
            val found = withContext(Dispatchers.IO) { Batteries.of(logs, folder) }
            change { found }
        }
    }

    /** Reads again what the team wrote down. */
    fun refresh() {
        written.value++
    }

    /** Writes down beside the log [file] that the battery called [name] was in the robot; an empty name takes that back. */
    fun assign(name: String, file: Path) {
        val folder = library.state.folder
        scope.launch {
            withContext(Dispatchers.IO) { FolderBatteries.assign(name.trim(), file, folder) }?.let(notices::complain)
            refresh()
        }
    }
}
