package badlog.web

import java.io.IOException
import java.io.OutputStream
import java.nio.ByteBuffer
import java.nio.channels.ReadableByteChannel

/** The downloads that may run at the same time: each has a buffer, which is made once and used again. */
internal class Downloads(private val pace: Pace, private val clock: Clock) {
    private val all = List(LIMIT) { Download() }

    /** Returns a download that no one else uses, to be given back by its `close`; null if all are in use. */
    @Synchronized
    fun take(): Download? {
        val free = all.firstOrNull { it.thread == null }
        if (free == null) {
            // Somebody walked away with a phone: the next one to ask gets the place.
            for (download in all) if (clock.nanos() - download.moved > PATIENCE_NANOS) download.thread?.interrupt()
            return null
        }
        free.thread = Thread.currentThread()
        free.moved = clock.nanos()
        return free
    }

    /** One of them. Used by the thread that took it. */
    inner class Download : AutoCloseable {
        private val buffer = ByteBuffer.allocate(BUFFER_BYTES)
        var thread: Thread? = null

        /** When something was last sent. */
        @Volatile
        var moved = 0L

        /**
         * Copies [length] bytes from [source] to [target] while [mayGoOn] says so. Nothing is allocated for the parts.
         *
         * @throws IOException if that fails, or if less came than [length].
         */
        fun copy(source: ReadableByteChannel, length: Long, target: OutputStream, mayGoOn: () -> Boolean) {
            var left = length
            while (left > 0) {
                buffer.clear().limit(left.coerceAtMost(BUFFER_BYTES.toLong()).toInt())
                val count = source.read(buffer)
                if (count < 0) throw IOException("The log became shorter while it was read.")
                pace.await(count)
                if (!mayGoOn()) throw IOException("The robot was enabled, or connected to the field.")
                target.write(buffer.array(), 0, count)
                moved = clock.nanos()
                left -= count
            }
        }

        override fun close(): Unit = synchronized(this@Downloads) { thread = null }
    }

    private companion object {
        const val LIMIT = 2

        /** A part is sent in 16 ms: often enough for a smooth download, and seldom enough to leave a processor alone. */
        const val BUFFER_BYTES = 16 * 1024

        const val PATIENCE_NANOS = 10_000_000_000L
    }
}
