package badlog.window.log

import badlog.viewer.draw.path.FieldFile
import java.nio.file.Path

/**
 * Reads recordings as the window shows them, on any thread.
 *
 * @param library gives the folder of logs.
 * @param definitions gives the formulas to calculate in each.
 * @param overTime says whether they are drawn over their time, see [OpenRecording.overTime].
 * @param field gives the field on which the paths of a log are drawn.
 */
internal class RecordingReader(
    private val library: () -> Path?,
    private val definitions: () -> List<String>,
    private val overTime: () -> Boolean,
    private val field: (Path) -> FieldFile,
) {
    /** Reads [file], see [OpenRecording.read]. */
    fun read(file: Path, isGrowing: Boolean = false, progress: (Float) -> Unit = {}): OpenRecording =
        OpenRecording.read(file, library(), definitions, overTime, isGrowing, field, progress)
}
