package badlog.report.hook

import java.io.IOException
import java.io.InputStream

/** Reads what a program writes, on a thread of its own, so that the program never waits. */
internal class PipeReader(private val stream: InputStream, private val most: Int, private val keepsEnd: Boolean) {
    private var bytes = ByteArray(0)

    /** Whether there was more than [most] bytes. */
    @Volatile
    var isTooLong = false
        private set
    private val thread = Thread(::read, "badlog-hook-pipe").apply {
        isDaemon = true
        start()
    }

    private fun read() {
        val piece = ByteArray(PIECE)
        try {
            while (true) {
                val size = stream.read(piece)
                if (size < 0) return
                append(piece, size)
            }
        } catch (_: IOException) {
            // The program was killed; what it had written counts.
        }
    }

    @Synchronized
    private fun append(piece: ByteArray, size: Int) {
        if (bytes.size + size <= most) {
            bytes += piece.copyOf(size)
        } else {
            isTooLong = true
            if (keepsEnd) bytes = (bytes + piece.copyOf(size)).let { it.copyOfRange(it.size - most, it.size) }
        }
    }

    /** Whether all was read within [millis] milliseconds. */
    fun join(millis: Long): Boolean {
        thread.join(maxOf(1, millis))
        return !thread.isAlive
    }

    /** What was read so far. */
    @Synchronized
    fun text(): String = bytes.decodeToString()

    private companion object {
        const val PIECE = 1 shl 16
    }
}
