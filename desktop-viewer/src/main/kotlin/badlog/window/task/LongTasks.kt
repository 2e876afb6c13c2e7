package badlog.window.task

import androidx.compose.runtime.mutableStateListOf
import kotlinx.coroutines.CancellationException
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.CoroutineStart
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.Job
import kotlinx.coroutines.delay
import kotlinx.coroutines.job
import kotlinx.coroutines.launch
import kotlinx.coroutines.runInterruptible
import java.io.IOException
import java.util.concurrent.atomic.AtomicReference

/**
 * A task that a person waits for.
 *
 * @property id identifies it.
 * @property title the current work, for the status bar.
 * @property share the fraction done, 0 to 1; null while unknown.
 * @property cancel cancels it.
 */
internal data class LongTask(val id: Int, val title: String, val share: Float?, val cancel: () -> Unit)

/**
 * Tasks that a person waits for, each with its progress and a way to cancel it. Use it only on the window's
 * thread.
 *
 * @param scope the scope for work; its thread is the window's.
 * @param notices receive failures.
 */
internal class LongTasks(private val scope: CoroutineScope, private val notices: Notices) {
    private val mutable = mutableStateListOf<LongTask>()
    private var lastId = 0

    /** The running tasks. */
    val all: List<LongTask> get() = mutable

    /**
     * Runs [work] off the window's thread, then [done] with its result on it. [work] may report the fraction done, 0 to 1, as
     * often as it likes; cancelling interrupts its thread. An [IOException] becomes an error notice, so its message must be a
     * sentence for people.
     */
    fun <T> run(title: String, work: (progress: (Float) -> Unit) -> T, done: (T) -> Unit): Job {
        val id = ++lastId
        val share = AtomicReference<Float?>(null)
        // Started immediately, because a task cancelled before its start would otherwise never be removed from the list.
        return scope.launch(start = CoroutineStart.UNDISPATCHED) {
            mutable += LongTask(id, title, null, coroutineContext.job::cancel)
            val shown = launch {
                while (true) {
                    delay(PROGRESS_MILLIS)
                    val at = mutable.indexOfFirst { it.id == id }
                    if (at >= 0) mutable[at] = mutable[at].copy(share = share.get())
                }
            }
            try {
                done(runInterruptible(Dispatchers.IO) { work { share.set(it) } })
            } catch (e: CancellationException) {
                throw e
            } catch (e: IOException) {
                notices.complain(e.message ?: "$title failed; try again.")
            } catch (_: OutOfMemoryError) {
                notices.complain("$title needs more memory than is available; close other logs and try again.")
            } finally {
                shown.cancel()
                mutable.removeAll { it.id == id }
            }
        }
    }

    private companion object {
        const val PROGRESS_MILLIS = 50L
    }
}
