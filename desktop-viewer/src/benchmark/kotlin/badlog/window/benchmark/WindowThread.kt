package badlog.window.benchmark

import kotlinx.coroutines.CoroutineDispatcher
import java.util.concurrent.LinkedBlockingQueue
import java.util.concurrent.TimeUnit
import kotlin.coroutines.CoroutineContext

/** Runs what is dispatched on the thread that asks for it: the window's thread of a window that is not there. */
internal class WindowThread : CoroutineDispatcher() {
    private val queue = LinkedBlockingQueue<Runnable>()

    override fun dispatch(context: CoroutineContext, block: Runnable) {
        queue += block
    }

    /** The milliseconds of the longest that ran without a break since this was set to 0. */
    var longest: Double = 0.0

    /** Runs all that waits. */
    fun runPending() {
        while (true) time((queue.poll() ?: return)::run)
    }

    /** Runs the next that comes, waiting for it no longer than a millisecond. */
    fun await() {
        queue.poll(1, TimeUnit.MILLISECONDS)?.let { time(it::run) }
    }

    /** Runs [block] as this thread. */
    fun time(block: () -> Unit) {
        val start = System.nanoTime()
        block()
        longest = maxOf(longest, (System.nanoTime() - start) / 1e6)
    }
}
