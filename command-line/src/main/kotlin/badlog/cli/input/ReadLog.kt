package badlog.cli.input

import badlog.cli.Failure
import badlog.file.readRecording
import badlog.html.ExportProgress
import badlog.recording.ProblemKind
import badlog.recording.Recording
import badlog.recording.RecordingFormat
import java.nio.file.Path

/**
 * Reads [file] with its samples, and with the topic [xTopic] as x axis when it is not null.
 *
 * @throws NotALog when there is nothing to show.
 * @throws badlog.cli.Failure when there is no such topic.
 * @throws badlog.file.UnreadableFileException when it cannot be read.
 */
internal fun readLog(file: Path, progress: ExportProgress, xTopic: String? = null): Recording {
    val recording = readRecording(file, progress = progress::advanced)
    recording.problems.firstOrNull { it.kind == ProblemKind.NOT_A_RECORDING }?.let { throw NotALog("$file: ${it.message}") }
    return if (xTopic == null) recording else recording.withX(xTopic, file)
}

/**
 * Reads [file] as [readLog] does, for what works on rows.
 *
 * @throws badlog.cli.Failure also for a WPILOG, whose topics have times of their own.
 */
internal fun readRows(file: Path, progress: ExportProgress, xTopic: String? = null): Recording {
    val recording = readLog(file, progress, xTopic)
    if (recording.format != RecordingFormat.WPILOG) return recording
    throw Failure("$file is a WPILOG, which has no rows; make a bag of it first: badlog convert --to bag.")
}
