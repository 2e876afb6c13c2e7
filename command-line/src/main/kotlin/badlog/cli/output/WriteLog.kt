package badlog.cli.output

import badlog.cli.input.FileName
import badlog.core.recording.ProblemKind
import badlog.core.recording.Recording
import badlog.files.GzipReader
import badlog.files.reading
import badlog.files.terminal.Progress
import badlog.files.unpacked
import badlog.files.writeAtomically
import badlog.formats.wpilog.Omission
import java.io.OutputStream
import java.nio.file.Files
import java.nio.file.Path
import java.util.zip.GZIPOutputStream

/**
 * Writes the rows [runs] of [recording], or its samples, to [target], atomically; gzipped if its name ends in `.gz`.
 *
 * @param changesOnly whether to skip samples that equal the previous ones.
 * @return the content that [format] cannot express.
 * @throws badlog.files.UnwritableFileException if it cannot be written.
 * @throws badlog.cli.input.Failure if the format needs rows, and there are none.
 */
internal fun writeLog(
    recording: Recording,
    format: OutputFormat,
    target: Path,
    runs: List<IntRange> = listOf(0 until recording.rowCount),
    changesOnly: Boolean = false,
    progress: Progress,
): Omissions {
    format.require(recording, target)
    return newLog(target) { stream ->
        format.write(recording, runs, changesOnly, progress::advanced) { bytes, size -> stream.write(bytes, 0, size) }
    } + roundedIn(recording)
}

/** Returns the whole numbers that were rounded when [recording] was read. */
private fun roundedIn(recording: Recording): Omissions = Omissions(
    omissions = recording.problems.filter { it.kind == ProblemKind.NUMBERS_ROUNDED }
        .map { Omission(it.topic, "Whole numbers beyond 2^53 are rounded.", it.count) },
)

/**
 * Creates [target] with the output of [write], atomically; gzipped if its name ends in `.gz`.
 *
 * @throws badlog.files.UnwritableFileException if it cannot be written.
 */
internal fun <T> newLog(target: Path, write: (OutputStream) -> T): T = writeAtomically(target) { out ->
    val gzip = if (FileName.of(target).isGzip) GZIPOutputStream(out, 1 shl 16) else null
    val written = write(gzip ?: out)
    gzip?.finish()
    written
}

/**
 * Makes [target] an exact copy of [log], inflated and possibly compressed again, without its last [lostBytes].
 *
 * @param progress called with the number of bytes copied so far, and the total.
 * @throws badlog.files.UnwritableFileException if it cannot be written.
 * @throws badlog.files.UnreadableFileException if the log cannot be read.
 */
internal fun copyBeginning(log: Path, lostBytes: Long, target: Path, progress: Progress) {
    var size = -lostBytes
    inflate(log) { _, count -> size += count }
    newLog(target) { stream ->
        var left = size
        inflate(log) { bytes, count ->
            val kept = minOf(left, count.toLong()).toInt()
            stream.write(bytes, 0, kept)
            left -= kept
            progress.advanced(size - left, size)
        }
    }
}

/** Passes the bytes of [log] to [sink], inflated if necessary. */
internal fun inflate(log: Path, sink: (ByteArray, Int) -> Unit) = unpacked(log) { unpacked -> inflateGzip(unpacked.path, sink) }

private fun inflateGzip(log: Path, sink: (ByteArray, Int) -> Unit) = reading(log) {
    Files.newInputStream(log).use { stream ->
        val piece = ByteArray(1 shl 16)
        var count = stream.readNBytes(piece, 0, piece.size)
        GzipReader(sink).use { gzip ->
            val isGzip = GzipReader.isGzip(piece, count)
            while (count > 0) {
                if (isGzip) gzip.accept(piece, 0, count) else sink(piece, count)
                count = stream.readNBytes(piece, 0, piece.size)
            }
        }
    }
}
