package badlog.files

import java.nio.ByteBuffer
import java.nio.ByteOrder
import java.nio.channels.FileChannel
import java.nio.file.Path

/** The bytes of an open file, in pieces. Failures become an [UnreadableFileException]. */
internal class FilePieces(val file: Path, private val channel: FileChannel, val progress: (doneBytes: Long, totalBytes: Long) -> Unit) {
    private val bytes = ByteArray(SIZE)

    /** The file's size when it was opened. */
    val total: Long = reading(file) { channel.size() }

    /** Returns the result of [look] for the first [size] bytes, or fewer if the file is shorter. The array is reused after the call. */
    fun <T> beginning(size: Int, look: (bytes: ByteArray, size: Int) -> T): T = look(bytes, readAt(0, size))

    /**
     * Returns the probable inflated size of a gzip file in bytes; 0 if its end does not show it. The trailer of its last member, if there
     * is one, states the inflated size of that member.
     */
    fun inflatedSize(): Long {
        if (readAt(maxOf(0, total - Int.SIZE_BYTES), Int.SIZE_BYTES) < Int.SIZE_BYTES) return 0
        val size = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).getInt().toUInt().toLong()
        return if (size in total..total * MAX_INFLATION) size else 0
    }

    /** Returns the position after the last line end; 0 if there is none. */
    fun lastLineEnd(): Long {
        var until = total
        while (until > 0) {
            val from = maxOf(0, until - SIZE)
            for (i in readAt(from, (until - from).toInt()) - 1 downTo 0) {
                if (bytes[i] == LINE_FEED || bytes[i] == CARRIAGE_RETURN) return from + i + 1
            }
            until = from
        }
        return 0
    }

    /** Passes all bytes before [until] to [sink], and reports the progress; stops once [enough] returns true. The array is reused after the call. */
    fun forEach(until: Long = Long.MAX_VALUE, enough: () -> Boolean = { false }, sink: (bytes: ByteArray, size: Int) -> Unit) {
        var done = 0L
        var reported = 0L
        while (done < until && !enough()) {
            val size = readAt(done, minOf(SIZE.toLong(), until - done).toInt())
            if (size == 0) break
            sink(bytes, size)
            done += size
            if (done - reported >= STEP) {
                reported = done
                progress(done, total)
            }
        }
        if (done > reported) progress(done, total)
    }

    /** Fills [bytes] from [position] on, with [size] bytes, or fewer at the end of the file. Returns their number. */
    private fun readAt(position: Long, size: Int): Int = reading(file) {
        val buffer = ByteBuffer.wrap(bytes, 0, size)
        while (buffer.hasRemaining()) {
            if (channel.read(buffer, position + buffer.position()) < 0) break
        }
        buffer.position()
    }
}

// Larger pieces are not faster.
private const val SIZE = 1 shl 18
private const val STEP = 1L shl 20

/** The maximum ratio of inflated to compressed size. A log with a larger ratio has lost its trailer. */
private const val MAX_INFLATION = 40
private const val LINE_FEED = '\n'.code.toByte()
private const val CARRIAGE_RETURN = '\r'.code.toByte()
