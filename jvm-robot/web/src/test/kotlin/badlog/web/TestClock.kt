package badlog.web

import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/** A clock at 0 that stands still, so that whoever waits does, until it [runs][run]; then each wait takes its time at once. */
internal class TestClock(private var isRunning: Boolean = false) : Clock() {
    private val lock = ReentrantLock()
    private val change = lock.newCondition()
    private var now = 0L

    /** How many wait. */
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
