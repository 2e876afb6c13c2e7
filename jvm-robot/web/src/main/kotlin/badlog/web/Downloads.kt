package badlog.web

import java.io.IOException
import java.io.OutputStream
import java.nio.ByteBuffer
import java.nio.channels.ReadableByteChannel

/** The downloads that may run at the same time. Each has a buffer that is created once and reused. */
internal class Downloads(private val pace: Pace, private val clock: Clock) {
    private val all = List(LIMIT) { Download() }

    /** Returns a free download; null if all are in use. Its `close` frees it again. */
    @Synchronized
    fun take(): Download? {
        val free = all.firstOrNull { it.thread == null }
        if (free == null) {
            // A download stands still, as when a phone leaves the network: the next request gets its place.
            for (download in all) if (clock.nanos() - download.moved > PATIENCE_NANOS) download.thread?.interrupt()
            return null
        }
        free.thread = Thread.currentThread()
        free.moved = clock.nanos()
        return free
    }

    /** One download. Only the thread that took it uses it. */
    inner class Download : AutoCloseable {
        private val buffer = ByteBuffer.allocate(BUFFER_BYTES)
        var thread: Thread? = null

        /** The time when bytes were last sent, in nanoseconds of [clock]. */
        @Volatile
        var moved = 0L

        /**
         * Copies [length] bytes from [source] to [target] while [mayGoOn] returns true. Nothing is allocated for the parts.
         *
         * @throws IOException if copying fails, or if [source] ends before [length] bytes.
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
}

private const val LIMIT = 2

/** The size of a part. One takes 16 ms, short enough for a smooth download, and long enough to spare the processor. */
private const val BUFFER_BYTES = 16 * 1024

private const val PATIENCE_NANOS = 10_000_000_000L
