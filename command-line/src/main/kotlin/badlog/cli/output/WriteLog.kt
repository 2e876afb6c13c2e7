package badlog.cli.output

import badlog.html.ExportProgress
import badlog.html.NewFile
import badlog.html.writing
import badlog.recording.Recording
import java.nio.file.Files
import java.nio.file.Path
import java.util.zip.GZIPOutputStream

/**
 * Writes the rows [runs] of [recording] to [target], which is there whole or as it was before; gzipped when its name ends so.
 *
 * @throws badlog.html.ExportException when it cannot be written.
 */
internal fun writeLog(
    recording: Recording,
    format: LogFormat,
    target: Path,
    runs: List<IntRange> = listOf(0 until recording.rowCount),
    progress: ExportProgress,
) {
    val total = runs.sumOf { it.count() }.toLong()
    val file = target.toAbsolutePath().normalize()
    writing(target) {
        Files.createDirectories(file.parent)
        NewFile(file).use { draft ->
            val gzip = if (FileName.of(file).isGzip) GZIPOutputStream(draft.out, 1 shl 16) else null
            val stream = gzip ?: draft.out
            val heard = { rows: Int -> progress.advanced(rows.toLong(), total) }
            format.write(recording, runs, heard) { bytes, size -> stream.write(bytes, 0, size) }
            gzip?.finish()
            draft.commit()
        }
    }
}
