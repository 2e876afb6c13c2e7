package badlog.cli.output

import badlog.cli.input.FileName
import badlog.file.GzipReader
import badlog.file.reading
import badlog.file.unpacked
import badlog.file.writeAtomically
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
 * @throws badlog.file.UnwritableFileException when it cannot be written.
 * @throws badlog.cli.input.Failure when the format needs rows, and there are none.
 */
internal fun writeLog(
    recording: Recording,
    format: LogFormat,
    target: Path,
    runs: List<IntRange> = listOf(0 until recording.rowCount),
    changesOnly: Boolean = false,
    progress: Progress,
): Omissions {
    format.require(recording, target)
    return newLog(target) { stream ->
        format.write(recording, runs, changesOnly, progress::advanced) { bytes, size -> stream.write(bytes, 0, size) }
    }
}

/**
 * Makes [target] of what [write] writes: there whole or as it was before, gzipped when its name ends so.
 *
 * @throws badlog.file.UnwritableFileException when it cannot be written.
 */
internal fun <T> newLog(target: Path, write: (OutputStream) -> T): T = writeAtomically(target) { out ->
    val gzip = if (FileName.of(target).isGzip) GZIPOutputStream(out, 1 shl 16) else null
    val written = write(gzip ?: out)
    gzip?.finish()
    written
}

/**
 * Makes [target] a copy of [log], inflated and perhaps compressed again, without its last [lostBytes], to the byte.
 *
 * @param progress hears how many bytes are copied, and how many there are.
 * @throws badlog.file.UnwritableFileException when it cannot be written.
 * @throws badlog.file.UnreadableFileException when the log cannot be read.
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

/** Gives the bytes of [log] to [sink], inflated if need be. */
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
