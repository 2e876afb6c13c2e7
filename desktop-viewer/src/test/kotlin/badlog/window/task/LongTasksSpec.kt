package badlog.window.task

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import kotlinx.coroutines.coroutineScope
import java.io.IOException
import java.util.concurrent.CountDownLatch

class LongTasksSpec : FunSpec({
    /** Returns the window's notices when a task called Opening ends by [failure]. */
    suspend fun saidOf(failure: Throwable): List<String> {
        val notices = Notices()
        coroutineScope {
            val tasks = LongTasks(this, notices)
            tasks.run("Opening", { throw failure }) { error("Nothing is done.") }.join()
            tasks.all.shouldBeEmpty()
        }
        return notices.all.filter { it.isError }.map { it.text }
    }

    test("a failed task is reported in a sentence, and ends no other task") {
        saidOf(IOException("The drive is gone; plug it in.")) shouldContainExactly listOf("The drive is gone; plug it in.")
        saidOf(OutOfMemoryError()) shouldContainExactly
            listOf("Opening needs more memory than is available; close other logs and try again.")
    }

    test("a canceled task is interrupted, and not reported") {
        val notices = Notices()
        coroutineScope {
            val tasks = LongTasks(this, notices)
            val isRunning = CountDownLatch(1)
            val job = tasks.run("Opening", {
                isRunning.countDown()
                CountDownLatch(1).await()
            }) { error("Nothing is done.") }
            tasks.run("Waiting", { isRunning.await() }) {}.join()
            tasks.all.single().let {
                it.title shouldBe "Opening"
                it.cancel()
            }
            job.join()
            tasks.all.shouldBeEmpty()
        }
        notices.all.shouldBeEmpty()
    }
})
