package badlog.window.task

import io.kotest.assertions.nondeterministic.eventually
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import kotlinx.coroutines.Dispatchers
import kotlinx.coroutines.MainScope
import kotlinx.coroutines.isActive
import kotlinx.coroutines.launch
import kotlinx.coroutines.withContext
import java.nio.file.Files
import java.util.concurrent.CountDownLatch
import kotlin.time.Duration.Companion.seconds

class FailuresSpec : FunSpec({
    test("a failure is reported and stored, and ends no other work") {
        val notices = Notices()
        val log = FailureLog(tempdir().toPath().resolve("cache"))
        val scope = Failures(log, notices).guarded(MainScope())
        repeat(2) { scope.launch { error("a defect") }.join() }
        eventually(60.seconds) { notices.all.single().text shouldContain log.file.toString() }
        scope.isActive shouldBe true
        Files.readString(log.file) shouldContain "a defect"
    }

    test("a failure that cannot be stored is reported, too") {
        val notices = Notices()
        val file = tempdir().toPath().resolve("file")
        Files.writeString(file, "where a folder should be")
        Failures(FailureLog(file.resolve("cache")), notices).handle(IllegalStateException())
        eventually(60.seconds) { notices.all.single().isError shouldBe true }
    }

    test("a task that is canceled before it has begun leaves no trace") {
        withContext(Dispatchers.Main) {
            val tasks = LongTasks(MainScope(), Notices())
            val job = tasks.run("Waiting", { CountDownLatch(1).await() }) {}
            tasks.all.single().cancel()
            job.join()
            tasks.all.shouldBeEmpty()
        }
    }
})
