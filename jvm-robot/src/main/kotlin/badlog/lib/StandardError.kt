package badlog.lib

import java.util.concurrent.LinkedBlockingQueue
import java.util.concurrent.atomic.AtomicInteger

/**
 * Says what went wrong on standard error, by a thread of its own: where that is a pipe that nobody reads, writing to it may never
 * return, and a robot's loop cannot wait for that. Messages that come while too many wait are left out. Never throws.
 */
internal object StandardError : Thread("badlog messages") {
    private const val MAX_WAITING = 400

    private val waiting = LinkedBlockingQueue<String>(MAX_WAITING)
    private val unsaid = AtomicInteger()

    init {
        isDaemon = true
    }

    /** Says [message] soon, as badlog's. */
    fun say(message: String) {
        unsaid.incrementAndGet()
        if (!waiting.offer(message)) unsaid.decrementAndGet()
        if (state != State.NEW) return
        try {
            start()
        } catch (_: IllegalThreadStateException) {
            // Another thread was quicker.
        } catch (_: OutOfMemoryError) {
            // The system has no thread for this; the next message tries again.
        }
    }

    /** Waits until all is said, but not longer than about [millis]; whether it is. */
    fun awaitSaid(millis: Int): Boolean {
        var left = millis
        while (unsaid.get() > 0 && left-- > 0) sleep(1)
        return unsaid.get() == 0
    }

    override fun run() {
        while (true) {
            try {
                val message = waiting.take()
                System.err.println("badlog: $message")
            } catch (_: Throwable) {
                // A program may have put a stream of its own there, and that may throw what it likes.
            }
            unsaid.decrementAndGet()
        }
    }
}
