package badlog.web

import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/**
 * A clock that stands still at 0, and keeps its callers waiting, until it [runs][run]. From then on, each wait moves the clock and returns
 * at once.
 */
internal class TestClock(private var isRunning: Boolean = false) : Clock() {
    private val lock = ReentrantLock()
    private val change = lock.newCondition()
    private var now = 0L

    /** The number of callers that wait. */
    val waiting: Int get() = lock.withLock { lock.getWaitQueueLength(change) }

    override fun nanos(): Long = lock.withLock { now }

    override fun awaitNanos(nanos: Long) = lock.withLock {
        while (!isRunning && now < nanos) change.await()
        now = maxOf(now, nanos)
    }

    fun advance(seconds: Long) = lock.withLock {
        now += seconds * 1_000_000_000
        change.signalAll()
    }

    fun run() = lock.withLock {
        isRunning = true
        change.signalAll()
    }
}
