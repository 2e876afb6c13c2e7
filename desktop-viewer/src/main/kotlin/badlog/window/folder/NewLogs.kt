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
 * The logs that have arrived in the folder, until somebody deals with them. Use it only on the window's thread.
 *
 * @param isShownByItself returns whether the window opened a log although nobody asked for it: then nobody has seen it yet.
 * @param ring makes a sound.
 */
internal class NewLogs(
    private val library: Library,
    private val current: CurrentRecording,
    private val settings: SettingsStore,
    private val isShownByItself: (Path) -> Boolean,
    private val ring: () -> Unit,
) : StateHolder<Arrivals<LogEntry>>(Arrivals()) {
    /** Follows the folder, until cancelled. */
    suspend fun run() = snapshotFlow { library.state.folder }.collectLatest {
        change { Arrivals() }
        combine(snapshotFlow { library.state }, snapshotFlow { current.recording?.file }, ::Pair).collect { (seen, open) ->
            if (seen.hasLooked && (state.hasBegun || seen.reading == null)) take(seen.entries)
            if (open != null && !isShownByItself(open)) change { without(open.toString()) }
        }
    }

    private fun take(entries: List<LogEntry>) {
        val before = state.latest
        change { knowing(entries) }
        val latest = state.latest
        if (latest != null && latest.source != before?.source && settings.state.ringsForLogs) ring()
    }

    /** Hides all that have arrived: somebody deals with them later. */
    fun leave() = change { dealtWith() }

    /** Returns the log that arrived last, with which somebody deals now; the others are in the list. */
    fun takeLatest(): LogEntry? = state.latest.also { leave() }
}
