package badlog.lib

import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicLong

/**
 * The clock of a log: the system's, or one that a test sets.
 *
 * @property given the current time in nanoseconds, as set by a test; null for the system's clock.
 */
internal open class LogTime(@JvmField val given: AtomicLong? = null) {
    /** The nanoseconds since a fixed moment. Inlined, because each row reads it several times, and should call nothing but the system. */
    inline val now: Long get() = if (given == null) System.nanoTime() else given.get()

    /** Returns pauses of [millis] each. */
    open fun pauses(millis: Long): Pauses = Pauses(millis)
}

/** The pauses of a thread that repeats its work until [end]. */
internal open class Pauses(private val millis: Long) {
    private val ended = CountDownLatch(1)

    /** Waits for one pause. Returns false when it is time to end. */
    open fun next(): Boolean = try {
        !ended.await(millis, TimeUnit.MILLISECONDS)
    } catch (_: InterruptedException) {
        // An interrupt does not end the thread; its work is only done a little earlier.
        true
    }

    /** Ends the thread soon, without waiting for it. */
    open fun end() = ended.countDown()
}
