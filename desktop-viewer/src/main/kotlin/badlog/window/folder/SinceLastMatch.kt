package badlog.window.folder

import androidx.compose.runtime.snapshotFlow
import badlog.catalog.folder.LogEntry
import badlog.rules.folder.FolderRules
import badlog.rules.number.LogNumbers
import badlog.rules.number.LogNumbersReader
import badlog.viewer.shown.folder.Changes
import badlog.viewer.shown.folder.changesOf
import badlog.viewer.shown.folder.earlierThan
import badlog.window.log.CurrentRecording
import badlog.window.state.StateHolder
import badlog.window.task.assertOffWindow
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.flow.collectLatest
import kotlinx.coroutines.withContext
import java.nio.file.Path

/** Compares the open log with earlier ones, whenever the rules have run over more of them. Use it only on the window's thread. */
internal class SinceLastMatch(private val current: CurrentRecording, private val library: Library) :
    StateHolder<Changes<LogEntry>>(Changes()) {
    private data class ComparisonInput(val folder: Path?, val earlier: List<LogEntry>, val log: LogEntry?)

    /** Follows the open log and the folder, until cancelled. */
    suspend fun run() {
        var shown: Path? = null
        snapshotFlow { compared() }.collectLatest { wanted ->
            if (wanted.log?.file != shown) change { Changes() }
            shown = wanted.log?.file
            val log = wanted.log ?: return@collectLatest
            val examined = library.examined
            val changes = withContext(Dispatchers.Default) {
                assertOffWindow()
                val reader = LogNumbersReader()
                changesOf(log, wanted.earlier, FolderRules.of(log.file, wanted.folder).rules) {
                    examined(it)?.numbers(reader) ?: LogNumbers.NONE
                }
            }
            change { changes }
        }
    }

    private fun compared(): ComparisonInput {
        val known = library.state.ofRobots.filter { !it.isGray && it.found?.rules != null }
        val log = known.find { it.file == current.recording?.file }
        return ComparisonInput(library.state.folder, log?.let { earlierThan(it, known) }.orEmpty(), log)
    }
}
