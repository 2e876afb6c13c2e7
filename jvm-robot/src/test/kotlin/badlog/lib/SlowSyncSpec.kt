package badlog.lib

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.ints.shouldBeInRange
import io.kotest.matchers.longs.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.io.File
import java.io.IOException
import java.util.concurrent.atomic.AtomicInteger

/** A disk that takes its time. */
private class SlowOutput(private val syncMillis: Long, private val append: () -> Unit = {}) : BagOutput {
    val syncs = AtomicInteger()
    override var length = 0L

    override fun append(bytes: ByteArray, size: Int) {
        append.invoke()
        length += size
    }

    override fun finish() = Unit

    override fun sync() {
        syncs.incrementAndGet()
        Thread.sleep(syncMillis)
    }

    override fun close(): Unit = throw IOException("gone")
}

class SlowSyncSpec : FunSpec({
    fun logFor(millis: Int, output: BagOutput): LogCounters = inFolder { folder ->
        val session = LogSession(flushesEachRow = true)
        val log = BadLog.start(session)
        session.logTo(LogFile(File(folder, "a.bag").apply { writeText("") }, output))
        BadLog.createTopicDouble("A", "ul", { 1.0 })
        log.finishInitialization()
        repeat(millis) {
            log.row()
            Thread.sleep(1)
        }
        log.close()
        log.counters()
    }

    test("a disk that takes a second to sync does not delay a row") {
        // A machine that does other things stalls any program now and then.
        List(3) { logFor(500, SlowOutput(1000)).slowestRowNanos }.min() shouldBeLessThan 20_000_000L
    }

    test("slow writes count, those that fail and the header's too") {
        val slow = SlowOutput(0) {
            Thread.sleep(10)
            throw IOException("full")
        }
        standardErrorOf {
            val counters = logFor(1, slow)
            // The header at the start and at the end.
            counters.slowWrites shouldBe 2
            counters.rowsMissed shouldBe 1
        }
    }

    test("a file that cannot be closed is said, and throws nothing") {
        standardErrorOf {
            val session = LogSession(flushesEachRow = true)
            session.logTo(LogFile(File("none"), SlowOutput(0)))
            BadLog.start(session).close()
        } shouldContain "could not be closed"
    }

    test("a quick disk is synced four times a second at most, and for the header") {
        val output = SlowOutput(0)
        val began = System.nanoTime()
        logFor(1000, output)
        val quarters = ((System.nanoTime() - began) / 250_000_000).toInt()
        output.syncs.get() shouldBeInRange 3..quarters + 2
    }
})
