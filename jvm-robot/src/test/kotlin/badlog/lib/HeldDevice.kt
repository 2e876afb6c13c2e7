package badlog.lib

import java.util.concurrent.CountDownLatch
import java.util.concurrent.TimeUnit

/**
 * A disk, or the like, that takes as long as a test wants. A log that waits for it keeps the test from releasing it, so it gives up
 * after a minute; a test checks that it did not.
 */
internal class HeldDevice {
    private val held = CountDownLatch(1)
    private val released = CountDownLatch(1)

    /** Whether it holds somebody up, or did. */
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

    /** Waits until it holds somebody up. */
    fun awaitHold() = check(held.await(LIMIT_MINUTES, TimeUnit.MINUTES)) { "Nobody uses this." }

    fun release() = released.countDown()

    private companion object {
        const val LIMIT_MINUTES = 1L
    }
}
