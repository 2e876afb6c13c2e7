package badlog.window.task

import kotlinx.coroutines.CoroutineScope
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.SupervisorJob
import kotlinx.coroutines.async
import kotlinx.coroutines.job
import kotlinx.coroutines.joinAll
import kotlinx.coroutines.runBlocking
import kotlinx.coroutines.withTimeoutOrNull
import kotlin.time.Duration.Companion.seconds

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
