package badlog.viewer.task

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
 * Something a person waits for.
 *
 * @property id identifies it.
 * @property title what is being done, as the status bar says it.
 * @property share how much is done, from 0 to 1; null while that is not known.
 * @property cancel gives it up.
 */
internal data class LongTask(val id: Int, val title: String, val share: Float?, val cancel: () -> Unit)

/**
 * What a person waits for, each with its progress and a way to give it up. To be used on the window's thread only.
 *
 * @param scope where work is launched; its thread is the window's.
 * @param notices hear what did not work.
 */
internal class LongTasks(private val scope: CoroutineScope, private val notices: Notices) {
    private val mutable = mutableStateListOf<LongTask>()
    private var lastId = 0

    /** Those that run now. */
    val all: List<LongTask> get() = mutable

    /**
     * Runs [work] off the window's thread, then [done] with its result on it. [work] may report how much of it is done, from 0 to
     * 1, as often as it likes; cancelling interrupts its thread. An [IOException] becomes a complaint, so its message
     * must be a sentence for a person.
     */
    fun <T> run(title: String, work: (progress: (Float) -> Unit) -> T, done: (T) -> Unit): Job {
        val id = ++lastId
        val share = AtomicReference<Float?>(null)
        // At once, or a task that is given up before it has begun would never be taken off the list.
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
