package badlog.networktables.record

import java.util.concurrent.TimeUnit
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/** An event on the connection [link]. */
internal sealed interface Incoming {
    val link: Link

    /** The connection is open. */
    class Opened(override val link: Link) : Incoming

    class Text(override val link: Link, val text: String) : Incoming

    /**
     * The values in the binary frame [frame].
     *
     * @property localMicros the arrival time of the frame.
     */
    class Values(override val link: Link, val frame: ByteArray, val localMicros: Long) : Incoming

    /**
     * The connection is closed because of [reason].
     *
     * @property localMicros the arrival time of its last message.
     */
    class Closed(override val link: Link, val reason: String, val localMicros: Long) : Incoming
}

/**
 * A queue of events to write, in limited memory: if the disk is too slow, values are dropped and counted. Thread-safe.
 *
 * @param limit the maximum size of waiting values, in bytes.
 */
internal class Inbox(private val limit: Long) {
    private val waiting = ArrayDeque<Incoming>()
    private val lock = ReentrantLock()
    private val arrival = lock.newCondition()
    private var bytes = 0L

    /** The number of dropped values. */
    var dropped: Long = 0
        get() = lock.withLock { field }
        private set

    /** Adds [incoming]. Returns false if there is no room for it. */
    fun add(incoming: Incoming): Boolean = lock.withLock {
        val size = sizeOf(incoming)
        if (size > 0 && bytes + size > limit) {
            if (incoming is Incoming.Values) dropped += countValues(incoming.frame)
            return false
        }
        bytes += size
        waiting.addLast(incoming)
        arrival.signal()
        true
    }

    /** Removes and returns the first event; null if none arrives within [millis]. */
    fun next(millis: Long): Incoming? = lock.withLock {
        var left = TimeUnit.MILLISECONDS.toNanos(millis)
        while (waiting.isEmpty()) {
            if (left <= 0) return null
            left = arrival.awaitNanos(left)
        }
        waiting.removeFirst().also { bytes -= sizeOf(it) }
    }

    private fun sizeOf(incoming: Incoming): Long = when (incoming) {
        is Incoming.Values -> incoming.frame.size + OVERHEAD
        is Incoming.Text -> 2L * incoming.text.length + OVERHEAD
        else -> 0
    }
}

private const val OVERHEAD = 64L
