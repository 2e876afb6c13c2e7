package badlog.lib

import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit

/**
 * A disk or another device that takes as long as a test wants. If the log waits for it on the test's thread, the test cannot release it, so
 * it gives up after a minute. Tests check that it did not.
 */
internal class HeldDevice {
    private val held = CountDownLatch(1)
    private val released = CountDownLatch(1)

    /** Whether a caller has been held up. */
    val isHolding: Boolean get() = held.count == 0L

    /** Whether it gave up. */
    @Volatile
    var isWaitedFor = false
        private set

    /** Returns when the test has called [release]. */
    fun hold() {
        held.countDown()
        if (!isWaitedFor && !released.await(LIMIT_MINUTES, TimeUnit.MINUTES)) isWaitedFor = true
    }

    /** Waits until a caller is held up. */
    fun awaitHold() = check(held.await(LIMIT_MINUTES, TimeUnit.MINUTES)) { "Nobody uses this." }

    fun release() = released.countDown()
}

private const val LIMIT_MINUTES = 1L
