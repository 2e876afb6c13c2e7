package badlog.cli.input

import badlog.file.readRecording
import badlog.html.ExportProgress
import badlog.recording.ProblemKind
import badlog.recording.Recording
import java.nio.file.Path

/**
 * Reads [file] with its samples.
 *
 * @throws NotALog when there is nothing to show.
 * @throws badlog.file.UnreadableFileException when it cannot be read.
 */
internal fun readLog(file: Path, progress: ExportProgress): Recording {
    val recording = readRecording(file, progress = progress::advanced)
    recording.problems.firstOrNull { it.kind == ProblemKind.NOT_A_RECORDING }?.let { throw NotALog("$file: ${it.message}") }
    return recording
}
