package badlog.cli.input

import badlog.core.recording.NumberSinks
import badlog.core.recording.Recording
import badlog.core.recording.RecordingFormat
import badlog.files.LogMaker
import badlog.files.ReadOptions
import badlog.files.readLog
import badlog.files.terminal.Progress
import badlog.formats.LOG_FORMATS
import badlog.formats.wpilog.WpilogFormat
import badlog.report.withX
import java.nio.file.Path

/**
 * Reads [file] with its samples, and with the topic [xTopic] as x axis unless it is null.
 *
 * @param maker makes one log from a file that contains several; null if such files are not read.
 * @param sinks the destinations of numbers that the recording is not to keep.
 * @throws badlog.files.NotReadException if there is nothing to show.
 * @throws badlog.report.TopicException if there is no such topic.
 * @throws Failure if the beginning of a WPILOG is lost.
 */
internal fun readLog(
    file: Path,
    progress: Progress,
    xTopic: String? = null,
    sinks: NumberSinks = NumberSinks.RECORDING,
    maker: LogMaker? = null,
): Recording {
    val recording = readLog(file, LOG_FORMATS, ReadOptions(sinks = sinks, maker = maker), progress::advanced).orThrow()
    if (isFormerWpilog(file, recording)) {
        throw Failure(
            "$file is named like a WPILOG, but does not begin like one: its beginning is lost, so nothing can be read.",
        )
    }
    return if (xTopic == null) recording else recording.withX(xTopic, file)
}

/** Any bytes with line ends count as a damaged table, in which a WPILOG could not be recognized. */
private fun isFormerWpilog(file: Path, recording: Recording) =
    recording.format == RecordingFormat.CSV && recording.isSalvaged && recording.rowCount > 0 &&
        FileName.of(file).ending.lowercase() in WpilogFormat.endings

/** Thrown if something cannot be done with a log. The message is one sentence for the user: what, where, and what to do. */
internal class Failure(override val message: String) : Exception(message)
