package badlog.lib

import java.util.concurrent.LinkedBlockingQueue
import java.util.concurrent.atomic.AtomicInteger

/**
 * Prints messages on standard error from its own thread. If standard error is a pipe without a reader, a write may never return, and a
 * robot's loop cannot wait for that. Messages that arrive while too many are waiting are dropped. Never throws.
 */
internal object StandardError : Thread("badlog messages") {
    private const val MAX_WAITING = 400

    private val waiting = LinkedBlockingQueue<String>(MAX_WAITING)
    private val unprinted = AtomicInteger()

    init {
        isDaemon = true
    }

    /** Queues [message] to be printed after `badlog: `; drops it if too many are waiting. */
    fun print(message: String) {
        unprinted.incrementAndGet()
        if (!waiting.offer(message)) unprinted.decrementAndGet()
        if (state != State.NEW) return
        try {
            start()
        } catch (_: IllegalThreadStateException) {
            // Another thread was faster.
        } catch (_: OutOfMemoryError) {
            // The system has no thread for this; the next message tries again.
        }
    }

    /** Waits until all messages are printed, for at most about [millis] ms. Returns whether they are. */
    fun awaitPrinted(millis: Int): Boolean {
        var left = millis
        while (unprinted.get() > 0 && left-- > 0) sleep(1)
        return unprinted.get() == 0
    }

    override fun run() {
        while (true) {
            try {
                val message = waiting.take()
                System.err.println("badlog: $message")
            } catch (_: Throwable) {
                // The program may have set a stream of its own, which may throw anything.
            }
            unprinted.decrementAndGet()
        }
    }
}
