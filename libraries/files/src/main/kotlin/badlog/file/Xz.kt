package badlog.file

import badlog.recording.Problem
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

/** Writes to [out] what of [file], which is compressed with xz, can be inflated; returns the problem that something is missing. */
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

/** Tells failures of reading [file] from what is wrong in it. */
private class ReadGuard(private val file: Path, source: InputStream) : FilterInputStream(source) {
    override fun read(): Int = reading(file) { super.read() }

    override fun read(bytes: ByteArray, from: Int, size: Int): Int = reading(file) { super.read(bytes, from, size) }
}

/** Where a file breaks off, what was inflated of a piece is lost. */
private const val PIECE = 1 shl 12

/** Twice what `xz -9` needs. */
private const val MEMORY_KB = 128 shl 10

/** No robot's log is larger, and a small file can hold anything. */
private const val MAX_BYTES = 4L shl 30
