package badlog.window.log

import badlog.viewer.choices.board.FolderLayout
import java.nio.file.Path

/**
 * Reads recordings as the window shows them, off its thread.
 *
 * @param library returns the folder of logs.
 * @param choices returns a person's choices for a log.
 */
internal class RecordingReader(private val library: () -> Path?, private val choices: (Path) -> RecordingChoices) {
    /**
     * Reads [file], see [OpenRecording.read].
     *
     * @param definitions returns the formulas to calculate in a log, given the layout beside it; null for the chosen formulas.
     */
    fun read(
        file: Path,
        isGrowing: Boolean = false,
        definitions: ((Path, FolderLayout) -> List<String>)? = null,
        progress: (Float) -> Unit = {},
    ): OpenRecording {
        fun choicesFor(layout: FolderLayout): RecordingChoices {
            val chosen = choices(file)
            return if (definitions == null) chosen else chosen.copy(definitions = definitions(file, layout))
        }
        return OpenRecording.read(file, library(), isGrowing, ::choicesFor, progress)
    }
}
