package badlog.window.task

import androidx.compose.runtime.mutableStateListOf
import kotlinx.coroutines.CancellationException
import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.CoroutineStart
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.Job
import kotlinx.coroutines.SupervisorJob
import kotlinx.coroutines.async
import kotlinx.coroutines.delay
import kotlinx.coroutines.job
import kotlinx.coroutines.joinAll
import kotlinx.coroutines.launch
import kotlinx.coroutines.runBlocking
import kotlinx.coroutines.runInterruptible
import kotlinx.coroutines.withTimeoutOrNull
import java.awt.EventQueue
import java.io.IOException
import java.util.concurrent.atomic.AtomicReference
import kotlin.time.Duration.Companion.seconds

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
}

/**
 * Asserts that work on files and whole logs is off the window's thread, which it would block. It has an effect only in tests and in
 * development.
 */
internal fun assertOffWindow() = assert(!EventQueue.isDispatchThread()) { "A file or a whole log is worked on by the window’s thread." }

/** Writes a person's changes to the disk, off the window's thread, one after another. Closing the window waits for them. */
internal class FileWrites {
    private val scope = CoroutineScope(SupervisorJob() + Dispatchers.IO.limitedParallelism(1))

    /** Runs [work] after all earlier work, and returns its result. It runs even if the caller is cancelled. */
    suspend fun <T> write(work: () -> T): T = scope.async { work() }.await()

    /** Runs [last], which may [write], and waits until everything is written. It waits only a moment if a USB stick does not respond. */
    fun finish(last: suspend () -> Unit = {}) {
        runBlocking {
            withTimeoutOrNull(LONGEST) {
                last()
                scope.coroutineContext.job.children.toList().joinAll()
            }
        }
    }

    private companion object {
        val LONGEST = 3.seconds
    }
}

private const val PROGRESS_MILLIS = 50L
