package badlog.window.folder

import androidx.compose.runtime.snapshotFlow
import badlog.catalog.folder.LogEntry
import badlog.viewer.shown.folder.Arrivals
import badlog.window.log.CurrentRecording
import badlog.window.settings.SettingsStore
import badlog.window.state.StateHolder
import kotlinx.coroutines.flow.collectLatest
import kotlinx.coroutines.flow.combine
import java.nio.file.Path

/**
 * The logs that have arrived in the folder, until a person deals with them. Use it only on the window's thread.
 *
 * @param recorded returns the log that this window is recording, which arrives only when it is finished; null for none.
 * @param isShownByItself returns whether the window opened a log by itself, so that no person has seen it yet.
 * @param ring makes a sound.
 */
internal class NewLogs(
    private val library: Library,
    private val current: CurrentRecording,
    private val settings: SettingsStore,
    private val recorded: () -> Path?,
    private val isShownByItself: (Path) -> Boolean,
    private val ring: () -> Unit,
) : StateHolder<Arrivals<LogEntry>>(Arrivals()) {
    /** Follows the folder, until cancelled. */
    suspend fun run() = snapshotFlow { library.state.folder }.collectLatest {
        change { Arrivals() }
        combine(snapshotFlow { library.state }, snapshotFlow { current.recording?.file to recorded() }, ::Pair).collect { (seen, files) ->
            val (open, growing) = files
            if (!state.hasBegun && seen.hasLooked) change { begun(seen.files.associate { "${it.path}" to it.size }) }
            val before = state.waiting.mapTo(HashSet()) { it.file }
            change { withEntries(seen.entries.filter { it.file != growing }) }
            if (open != null && !isShownByItself(open)) seen(open)
            if (settings.state.ringsForLogs && state.waiting.any { it.file !in before }) ring()
        }
    }

    /** Remembers that a person has opened [file]. */
    fun seen(file: Path) = change { without("$file") }

    /** Hides all arrived logs: a person deals with them later, or has seen them. */
    fun leave() = change { dealtWith() }

    /** Returns the worst log of the match that arrived last, and hides all arrived logs; null if there are none. */
    fun takeLatest(): LogEntry? = state.latest?.worst.also { leave() }
}
