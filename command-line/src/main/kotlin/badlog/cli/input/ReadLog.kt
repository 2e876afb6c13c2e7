package badlog.cli.input

import badlog.file.readRecording
import badlog.formats.LOG_FORMATS
import badlog.recording.NumberSinks
import badlog.recording.ProblemKind
import badlog.recording.Recording
import badlog.recording.RecordingFormat
import badlog.report.withX
import badlog.terminal.Progress
import java.nio.file.Path

/**
 * Reads [file] with its samples, and with the topic [xTopic] as x axis when it is not null.
 *
 * @param sinks where the numbers of topics go that the recording is not to have.
 * @throws NotALog when there is nothing to show.
 * @throws badlog.report.TopicException when there is no such topic.
 * @throws Failure when the beginning of a WPILOG is lost.
 * @throws badlog.file.UnreadableFileException when it cannot be read.
 */
internal fun readLog(file: Path, progress: Progress, xTopic: String? = null, sinks: NumberSinks = NumberSinks.RECORDING): Recording {
    val recording = readRecording(file, LOG_FORMATS, sinks = sinks, progress = progress::advanced)
    recording.problems.firstOrNull { it.kind == ProblemKind.NOT_A_RECORDING }?.let { throw NotALog("$file: ${it.message}") }
    if (isFormerWpilog(file, recording)) {
        throw Failure(
            "$file is named like a WPILOG, but does not begin like one: its beginning is lost, so nothing can be read.",
        )
    }
    return if (xTopic == null) recording else recording.withX(xTopic, file)
}

/** Any bytes with line ends among them are a damaged table; those of a WPILOG make none that anyone would know. */
private fun isFormerWpilog(file: Path, recording: Recording) =
    recording.format == RecordingFormat.CSV && recording.isSalvaged && recording.rowCount > 0 &&
        FileName.of(file).ending.lowercase() == ".wpilog"

/** The bytes of a file are not a log at all. The message is one sentence for a person. */
internal class NotALog(override val message: String) : Exception(message)

/** Why something cannot be done with a log. The message is one sentence for a person: what, where, and what to do. */
internal class Failure(override val message: String) : Exception(message)
