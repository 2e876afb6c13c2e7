package badlog.viewer.takeaway.cut

import badlog.bag.RecordingWriter
import badlog.plot.Span
import badlog.recording.RecordingFormat
import badlog.viewer.files.writeWhole
import badlog.viewer.recording.OpenRecording
import java.io.IOException
import java.nio.file.Files
import java.nio.file.Path

/**
 * Writes the rows of [recording] that lie in [span] to [target], as [format], and returns how many there were. A bag keeps the
 * values and the attributes.
 *
 * @throws IOException with a sentence for the person, when there is nothing to write or [target] is the recording's own file.
 */
internal fun cutFile(
    recording: OpenRecording,
    span: Span,
    format: RecordingFormat,
    target: Path,
    progress: (Float) -> Unit = {},
): Int {
    val rows = rowsWithin(recording, span)
    if (rows.isEmpty()) throw IOException("There are no samples in what is visible; show a part of the recording that has some.")
    if (Files.exists(target) && Files.exists(recording.file) && Files.isSameFile(target, recording.file)) {
        throw IOException("${target.fileName} is the open log itself, which its part must not replace; choose another name.")
    }
    writeWhole(target) { out ->
        val heard = { done: Int, total: Int ->
            if (Thread.interrupted()) throw InterruptedException()
            progress(done.toFloat() / total)
        }
        RecordingWriter(recording.view.recording, format).write(rows.first, rows.last + 1, heard) { bytes, size ->
            out.write(bytes, 0, size)
        }
    }
    return rows.last + 1 - rows.first
}
