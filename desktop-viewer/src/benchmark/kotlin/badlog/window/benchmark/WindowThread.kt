package badlog.window.benchmark

import kotlinx.coroutines.CoroutineDispatcher
import java.util.concurrent.LinkedBlockingQueue
import java.util.concurrent.TimeUnit
import kotlin.coroutines.CoroutineContext

/** Queues dispatched work and runs it on the calling thread, in place of the thread of a real window. */
internal class WindowThread : CoroutineDispatcher() {
    private val queue = LinkedBlockingQueue<Runnable>()

    override fun dispatch(context: CoroutineContext, block: Runnable) {
        queue += block
    }

    /** The duration in milliseconds of the longest work without a break since this was set to 0. */
    var longest: Double = 0.0

    /** Runs all queued work. */
    fun runPending() {
        while (true) time((queue.poll() ?: return)::run)
    }

    /** Runs the next queued work, and waits for it at most a millisecond. */
    fun await() {
        queue.poll(1, TimeUnit.MILLISECONDS)?.let { time(it::run) }
    }

    /** Runs [block], and records its duration in [longest]. */
    fun time(block: () -> Unit) {
        val start = System.nanoTime()
        block()
        longest = maxOf(longest, (System.nanoTime() - start) / 1e6)
    }
}
