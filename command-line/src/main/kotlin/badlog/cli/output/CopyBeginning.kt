package badlog.cli.output

import badlog.bag.FileSignature
import badlog.file.GzipReader
import badlog.file.reading
import badlog.terminal.Progress
import java.nio.file.Files
import java.nio.file.Path

/**
 * Makes [target] a copy of [log], inflated and perhaps compressed again, without its last [lostBytes], to the byte.
 *
 * @param progress hears how many bytes are copied, and how many there are.
 * @throws badlog.html.ExportException when it cannot be written.
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

private fun inflate(log: Path, sink: (ByteArray, Int) -> Unit) = reading(log) {
    Files.newInputStream(log).use { stream ->
        val piece = ByteArray(1 shl 16)
        var count = stream.readNBytes(piece, 0, piece.size)
        GzipReader(sink).use { gzip ->
            val isGzip = FileSignature.of(piece, count) == FileSignature.GZIP
            while (count > 0) {
                if (isGzip) gzip.accept(piece, 0, count) else sink(piece, count)
                count = stream.readNBytes(piece, 0, piece.size)
            }
        }
    }
}
