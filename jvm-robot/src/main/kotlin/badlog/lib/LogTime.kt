package badlog.lib

import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicLong

/**
 * The time of a log is the system's, unless a test gives its own.
 *
 * @property given the current time in nanoseconds; null for the system's.
 */
internal open class LogTime(@JvmField val given: AtomicLong? = null) {
    /** Nanoseconds since some moment. Inlined, so that the rows, each of which asks several times, call nothing but the system. */
    inline val now: Long get() = if (given == null) System.nanoTime() else given.get()

    /** Returns pauses of [millis] each. */
    open fun pauses(millis: Long): Pauses = Pauses(millis)
}

/** The pauses of a thread that does its work again and again, until [end]. */
internal open class Pauses(private val millis: Long) {
    private val ended = CountDownLatch(1)

    /** Waits a while. Returns false when it is time to end. */
    open fun next(): Boolean = try {
        !ended.await(millis, TimeUnit.MILLISECONDS)
    } catch (_: InterruptedException) {
        // An interrupt does not end the thread; it only does its work a little earlier.
        true
    }

    /** Ends the thread soon, without waiting for it. */
    open fun end() = ended.countDown()
}
