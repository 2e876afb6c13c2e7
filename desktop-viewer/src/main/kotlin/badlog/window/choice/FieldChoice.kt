package badlog.window.choice

import androidx.compose.runtime.snapshots.Snapshot
import badlog.viewer.draw.path.FieldFile
import badlog.window.compare.ComparedRecordings
import badlog.window.files.FileChoice
import badlog.window.log.CurrentRecording
import badlog.window.settings.SettingsStore
import badlog.window.task.Notices
import java.nio.file.Path

/**
 * The field on which paths are drawn: the one beside the logs, or one that a person has selected for the folder of logs, which is
 * remembered.
 *
 * @param folder returns the folder of logs.
 */
internal class FieldChoice(
    private val current: CurrentRecording,
    private val compared: ComparedRecordings,
    private val settings: SettingsStore,
    private val files: FileChoice,
    private val notices: Notices,
    private val folder: () -> Path?,
) {
    /** Whether a person has selected one for the current recording. */
    val isSelected: Boolean get() = current.recording?.let { selectedFor(it.file) } != null

    /** Returns the field of [log]. Reads it, on any thread. */
    fun of(log: Path): FieldFile = selectedFor(log)?.let(FieldFile::read) ?: FieldFile.of(log, folder())

    /** Asks for the file of a field, and draws paths on that from now on. */
    fun askForField() {
        val log = current.recording?.file ?: return
        val file = files.toRead("Select a field file", selectedFor(log)?.parent ?: log.parent, ".json") ?: return
        FieldFile.read(file).problem?.let { return notices.complain(it) }
        settings.change { withField("${folderOf(log)}", "${file.toAbsolutePath()}") }
        show()
    }

    /** Draws paths on the field beside the logs again. */
    fun deselect() {
        val log = current.recording?.file ?: return
        settings.change { withField("${folderOf(log)}", null) }
        show()
    }

    private fun show() = Snapshot.withMutableSnapshot {
        val drawn = compared.drawn.map { it.recording.withField(of(it.recording.file)) }
        drawn.firstOrNull()?.let(current::replace)
        drawn.forEach(compared::share)
    }

    private fun selectedFor(log: Path): Path? = settings.state.fields["${folderOf(log)}"]?.let(Path::of)

    private fun folderOf(log: Path): Path = folder()?.takeIf(log::startsWith) ?: log.parent
}
