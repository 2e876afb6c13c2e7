package badlog.files

import io.kotest.assertions.throwables.shouldThrow
import io.kotest.core.spec.style.FunSpec
import io.kotest.engine.spec.tempdir
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.shouldBe
import java.util.concurrent.CancellationException
import java.util.concurrent.CountDownLatch
import kotlin.io.path.writeText

class FolderRunSpec : FunSpec({
    val folder = tempdir().toPath()
    val files = (1..5).map { LogFile.of(folder.resolve("$it.csv").apply { writeText("Time,A\n") }) }

    test("results come in the order of the files, whichever takes longest") {
        val last = CountDownLatch(1)
        val names = ArrayList<String>()
        val work = { file: LogFile, _: Int ->
            if (file == files[0]) last.await()
            if (file == files[1]) last.countDown()
            file.name
        }
        FolderRun(threads = 2).forEach(files, work) { file, name ->
            name shouldBe file.name
            names += name
        }
        names shouldContainExactly files.map { it.name }
    }

    test("the callback for waiting is called during a long file") {
        val called = CountDownLatch(2)
        var done = 0
        FolderRun(threads = 1).forEach(files.take(1), { _, _ -> called.await() }, called::countDown) { _, _ -> done++ }
        done shouldBe 1
    }

    test("the callback for waiting can cancel within a long file") {
        val isInterrupted = CountDownLatch(1)
        val never = CountDownLatch(1)
        val work = { _: LogFile, _: Int ->
            try {
                never.await()
            } catch (_: InterruptedException) {
                isInterrupted.countDown()
            }
        }
        shouldThrow<CancellationException> { FolderRun(threads = 1).forEach(files, work, { throw CancellationException() }) { _, _ -> } }
        isInterrupted.await()
    }
})
