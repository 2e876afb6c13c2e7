package badlog.window.layout

import androidx.compose.runtime.snapshotFlow
import badlog.viewer.choices.board.FolderLayout
import badlog.viewer.choices.board.keptLayoutAfter
import badlog.viewer.choices.board.noLayoutKept
import badlog.window.folder.Library
import badlog.window.log.CurrentRecording
import badlog.window.state.StateHolder
import badlog.window.task.LongTasks
import badlog.window.task.Notices
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.flow.collectLatest
import kotlinx.coroutines.runInterruptible
import java.io.IOException
import java.nio.file.Path

/**
 * The layouts that are kept in a folder.
 *
 * @property files their files by their names, in the order of these.
 * @property shown the name of the one whose graphs a person asked for last; null for none.
 */
internal data class LayoutsOfFolder(val files: Map<String, Path> = emptyMap(), val shown: String? = null)

/** The layouts in the folder of logs, between which a key switches: files that a person has saved there under names of their own. */
internal class KeptLayouts(
    private val library: Library,
    private val current: CurrentRecording,
    private val layouts: LayoutStore,
    private val tasks: LongTasks,
    private val notices: Notices,
) : StateHolder<LayoutsOfFolder>(LayoutsOfFolder()) {
    private val folder: Path? get() = library.state.folder ?: current.recording?.file?.parent

    /** Looks for those of each folder that is opened, until cancelled. */
    suspend fun run() = snapshotFlow { folder }.collectLatest { opened ->
        change { LayoutsOfFolder() }
        if (opened == null) return@collectLatest
        try {
            val found = runInterruptible(Dispatchers.IO) { FolderLayout.keptIn(opened) }
            change { copy(files = found) }
        } catch (_: IOException) {
            // The list of logs says that the folder cannot be read.
        }
    }

    /** Shows the graphs of the one that is [steps] after the one shown; looks for files that were saved meanwhile. */
    fun step(steps: Int) {
        val folder = folder ?: return
        tasks.run("Looking for layouts", { FolderLayout.keptIn(folder) }) { found ->
            change { copy(files = found) }
            val next = keptLayoutAfter(found.keys.toList(), state.shown, steps)
            if (next == null) notices.say(noLayoutKept("Ctrl+S saves one beside the logs")) else show(next)
        }
    }

    /** Shows the graphs of the layout called [name], in the range that is visible. */
    fun show(name: String) {
        val file = state.files[name] ?: return
        tasks.run("Opening $name", { readLayout(file) }) { layout ->
            change { copy(shown = name) }
            layouts.switchTo(layout)
            notices.say("Layout “$name”.")
        }
    }

    /** Lists the layout that was saved as [file], if that is beside the logs. */
    fun add(file: Path) {
        val name = file.fileName.toString().removeSuffix(Layout.ENDING)
        if (file.parent == folder) change { LayoutsOfFolder((files + (name to file)).toSortedMap(String.CASE_INSENSITIVE_ORDER), name) }
    }
}
