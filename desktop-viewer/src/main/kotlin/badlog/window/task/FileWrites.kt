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

/** What people wrote, on its way to the disk: off the window's thread, one after another, and to the end when the window is closed. */
internal class FileWrites {
    private val scope = CoroutineScope(SupervisorJob() + Dispatchers.IO.limitedParallelism(1))

    /** Does [work], after all before it, and returns its result. It is done even if the caller is cancelled. */
    suspend fun <T> write(work: () -> T): T = scope.async { work() }.await()

    /** Does [last], which may [write], and waits until all is written; for a stick that does not answer, only a moment. */
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
