package badlog.report.hook

import java.io.IOException
import java.io.InputStream

/** Reads the output of a program on a separate thread, so that the program never waits. */
internal class PipeReader(private val stream: InputStream, private val most: Int, private val keepsEnd: Boolean) {
    private var bytes = ByteArray(minOf(most, PIECE))
    private var count = 0

    /** Whether the program wrote more than [most] bytes. */
    @Volatile
    var isTooLong = false
        private set
    private val thread = Thread(::read, "badlog-hook-pipe").apply {
        isDaemon = true
        start()
    }

    private fun read() {
        val piece = ByteArray(minOf(most, PIECE))
        try {
            while (true) {
                val size = stream.read(piece)
                if (size < 0) return
                append(piece, size)
            }
        } catch (_: IOException) {
            // The program was killed; its output before that counts.
        }
    }

    @Synchronized
    private fun append(piece: ByteArray, size: Int) {
        if (size > most - count) {
            isTooLong = true
            if (!keepsEnd) return
            bytes.copyInto(bytes, 0, size - (most - count), count)
            count = most - size
        }
        if (size > bytes.size - count) bytes = bytes.copyOf(minOf(most, maxOf(bytes.size * 2, count + size)))
        piece.copyInto(bytes, count, 0, size)
        count += size
    }

    /** Waits for at most [millis] ms. Returns whether everything was read. */
    fun join(millis: Long): Boolean {
        thread.join(maxOf(1, millis))
        return !thread.isAlive
    }

    /** Returns the text that was read so far. */
    @Synchronized
    fun text(): String = bytes.decodeToString(0, count)
}

private const val PIECE = 1 shl 16
