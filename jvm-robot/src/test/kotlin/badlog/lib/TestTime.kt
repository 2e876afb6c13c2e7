package badlog.lib

import java.util.concurrent.TimeUnit
import java.util.concurrent.atomic.AtomicLong
import java.util.concurrent.locks.ReentrantLock
import kotlin.concurrent.withLock

/** Time that passes only when a test says so. A log's threads then work at their own moments, one after the other. */
internal class TestTime : LogTime(AtomicLong()) {
    private val clock = checkNotNull(given)
    private val lock = ReentrantLock()
    private val changed = lock.newCondition()
    private val working = ArrayList<TestPauses>()

    /** The threads that have paused so far. */
    val threads: Set<Thread> get() = lock.withLock { working.mapNotNull { it.thread }.toSet() }

    override fun pauses(millis: Long): Pauses = TestPauses(millis * NANOS_PER_MILLI).also { lock.withLock { working += it } }

    /** Lets [millis] pass. When this returns, the threads with pauses that end in that time have done their work, and pause again. */
    fun pass(millis: Long) = pass(millis) { if (!changed.await(LIMIT_MINUTES, TimeUnit.MINUTES)) error("A thread of the log does not pause.") }

    /** Lets [millis] pass, and repeats [work] while the threads do theirs. */
    fun passWhile(millis: Long, work: () -> Unit) = pass(millis) {
        // The threads need it.
        lock.unlock()
        try {
            work()
        } finally {
            lock.lock()
        }
    }

    /** Waits until all threads have done the work that is due now. */
    fun settle() = pass(0)

    /** Waits until all threads have ended. */
    fun awaitEnd() = threads.forEach {
        it.join(TimeUnit.MINUTES.toMillis(LIMIT_MINUTES))
        check(!it.isAlive) { "A thread of the log does not end." }
    }

    /** Lets [millis] pass before any thread can do its work, as if the caller were held up. */
    fun stall(millis: Long) {
        clock.addAndGet(millis * NANOS_PER_MILLI)
    }

    private inline fun pass(millis: Long, await: () -> Unit) = lock.withLock {
        val end = clock.get() + millis * NANOS_PER_MILLI
        while (true) {
            // Work at the end of a thread is not awaited.
            while (working.any { it.isWorking && !it.isEnded }) await()
            val next = working.filter { !it.isEnded && it.due <= end }.minByOrNull { it.due } ?: break
            clock.set(maxOf(clock.get(), next.due))
            next.isWorking = true
            changed.signalAll()
        }
        clock.set(end)
    }

    /** The pauses of one thread, which works from its start. Guarded by the lock. */
    private inner class TestPauses(private val nanos: Long) : Pauses(0) {
        var thread: Thread? = null
        var isWorking = true
        var isEnded = false
        var due = 0L

        override fun next(): Boolean = lock.withLock {
            thread = Thread.currentThread()
            due = clock.get() + nanos
            isWorking = false
            changed.signalAll()
            while (!isWorking && !isEnded) changed.await()
            !isEnded
        }

        override fun end() = lock.withLock {
            isEnded = true
            changed.signalAll()
        }
    }
}

private const val NANOS_PER_MILLI = 1_000_000L
private const val LIMIT_MINUTES = 1L
