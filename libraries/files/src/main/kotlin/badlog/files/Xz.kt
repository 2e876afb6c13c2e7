package badlog.files

import badlog.core.recording.Problem
import org.tukaani.xz.MemoryLimitException
import org.tukaani.xz.XZIOException
import org.tukaani.xz.XZInputStream
import java.io.EOFException
import java.io.FilterInputStream
import java.io.IOException
import java.io.InputStream
import java.io.OutputStream
import java.nio.file.Files
import java.nio.file.Path

/** Inflates [file], which is compressed with xz, into [out], up to damage or 4 GB. Returns a problem if data is missing. */
internal fun inflateXz(file: Path, out: OutputStream, checkpoint: () -> Unit): List<Problem> {
    var inflated = 0L
    reading(file) { ReadGuard(file, Files.newInputStream(file)) }.use { source ->
        try {
            val stream = XZInputStream(source.buffered(), MEMORY_KB)
            val piece = ByteArray(PIECE)
            while (inflated < MAX_BYTES) {
                val size = stream.read(piece)
                if (size < 0) return emptyList()
                out.write(piece, 0, size)
                inflated += size
                checkpoint()
            }
        } catch (e: MemoryLimitException) {
            throw UnreadableFileException(
                file,
                "$file takes ${e.memoryNeeded shr 10} MB of memory to inflate; inflate it with xz first.",
                e,
            )
        } catch (e: IOException) {
            if (e !is XZIOException && e !is EOFException) throw e
        }
    }
    return listOf(compressedCut(inflated))
}

/** Distinguishes failures of reading [file] from errors in its content. */
private class ReadGuard(private val file: Path, source: InputStream) : FilterInputStream(source) {
    override fun read(): Int = reading(file) { super.read() }

    override fun read(bytes: ByteArray, from: Int, size: Int): Int = reading(file) { super.read(bytes, from, size) }
}

/** If a file ends early, the inflated part of a piece is lost. */
private const val PIECE = 1 shl 12

/** Twice the need of `xz -9`. */
private const val MEMORY_KB = 128 shl 10

/** No robot's log is larger, but a small file can inflate to any size. */
private const val MAX_BYTES = 4L shl 30
