package badlog.window.choice

import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableIntStateOf
import androidx.compose.runtime.setValue
import badlog.viewer.draw.path.FieldFile
import badlog.window.files.FileChoice
import badlog.window.log.CurrentRecording
import badlog.window.log.OpenRecording
import badlog.window.settings.SettingsStore
import badlog.window.task.LongTasks
import badlog.window.task.Notices
import java.nio.file.Path

/**
 * The field on which paths are drawn: the one beside the logs, or one that a person selected. A selection is remembered for the folder of
 * logs.
 *
 * @param folder returns the folder of logs.
 */
internal class FieldChoice(
    private val current: CurrentRecording,
    private val settings: SettingsStore,
    private val files: FileChoice,
    private val tasks: LongTasks,
    private val notices: Notices,
    private val folder: () -> Path?,
) {
    /** The number of selections since the window was opened. */
    var selections: Int by mutableIntStateOf(0)
        private set

    /** Whether a person has selected a field for the current recording. */
    val isSelected: Boolean get() = current.recording?.let { selectedFor(it.file) } != null

    /** Returns the field of [log], which need not be open. Reads files: call it off the window's thread. */
    fun of(log: Path): FieldFile = OpenRecording.fieldOf(log, selectedFor(log), folder())

    /** Asks for a field file, and draws paths on that field from now on. */
    fun askForField() {
        val log = current.recording?.file ?: return
        val file = files.toRead("Select a field file", selectedFor(log)?.parent ?: log.parent, ".json") ?: return
        tasks.run("Reading ${file.fileName}", { FieldFile.read(file).problem }) { problem ->
            if (problem != null) return@run notices.complain(problem)
            settings.change { withField("${folderOf(log)}", "${file.toAbsolutePath()}") }
            selections++
        }
    }

    /** Draws paths on the field beside the logs again. */
    fun deselect() {
        val log = current.recording?.file ?: return
        settings.change { withField("${folderOf(log)}", null) }
    }

    /** Returns the field file that a person has selected for [log]; null for none. */
    fun selectedFor(log: Path): Path? = settings.state.fields["${folderOf(log)}"]?.let(Path::of)

    private fun folderOf(log: Path): Path = folder()?.takeIf(log::startsWith) ?: log.toAbsolutePath().parent
}
