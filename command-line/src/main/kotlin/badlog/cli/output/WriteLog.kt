package badlog.cli.output

import badlog.html.NewFile
import badlog.html.writing
import badlog.recording.Recording
import badlog.terminal.Progress
import java.io.OutputStream
import java.nio.file.Files
import java.nio.file.Path
import java.util.zip.GZIPOutputStream

/**
 * Writes the rows [runs] of [recording], or its samples, to [target], which is there whole or as it was before; gzipped when
 * its name ends so.
 *
 * @param changesOnly whether samples are left out that are the same as those before them.
 * @return what [format] has no place for.
 * @throws badlog.html.ExportException when it cannot be written.
 * @throws badlog.cli.Failure when the format needs rows, and there are none.
 */
internal fun writeLog(
    recording: Recording,
    format: LogFormat,
    target: Path,
    runs: List<IntRange> = listOf(0 until recording.rowCount),
    changesOnly: Boolean = false,
    progress: Progress,
): LeftOut {
    format.require(recording, target)
    return newLog(target) { stream ->
        format.write(recording, runs, changesOnly, progress::advanced) { bytes, size -> stream.write(bytes, 0, size) }
    }
}

/**
 * Makes [target] of what [write] writes: there whole or as it was before, gzipped when its name ends so.
 *
 * @throws badlog.html.ExportException when it cannot be written.
 */
internal fun <T> newLog(target: Path, write: (OutputStream) -> T): T {
    val file = target.toAbsolutePath().normalize()
    return writing(target) {
        Files.createDirectories(file.parent)
        NewFile(file).use { draft ->
            val gzip = if (FileName.of(file).isGzip) GZIPOutputStream(draft.out, 1 shl 16) else null
            val written = write(gzip ?: draft.out)
            gzip?.finish()
            draft.commit()
            written
        }
    }
}
