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

    /** Runs all that waits. */
    fun runPending() {
        while (true) (queue.poll() ?: return).run()
    }

    /** Runs the next that comes, waiting for it no longer than a millisecond. */
    fun await() {
        queue.poll(1, TimeUnit.MILLISECONDS)?.run()
    }
}
