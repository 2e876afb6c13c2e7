package badlog.lib

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.io.File
import java.io.IOException
import java.util.concurrent.atomic.AtomicInteger

/** A slow disk with the behavior that a test passes as [append], [finish], [sync] and [close]. */
private class SlowOutput(
    private val append: () -> Unit = {},
    private val finish: () -> Unit = {},
    private val sync: () -> Unit = {},
    private val close: () -> Unit = {},
) : BagOutput {
    val appends = AtomicInteger()
    val syncs = AtomicInteger()
    override var length = 0L

    override fun append(bytes: ByteArray, size: Int) {
        appends.incrementAndGet()
        append.invoke()
        length += size
    }

    override fun finish() = finish.invoke()

    override fun sync() {
        syncs.incrementAndGet()
        sync.invoke()
    }

    override fun rename(to: File, lock: Any) = false

    override fun close() = close.invoke()
}

class SlowSyncSpec : FunSpec({
    /** Runs [loop] with a log that is written to [output]. Returns its counters. */
    fun logTo(output: BagOutput, time: LogTime, loop: (BadLog) -> Unit): LogCounters = inFolder { folder ->
        val session = LogSession(flushesEachRow = true, time)
        val log = BadLog.start(session)
        session.logTo(LogFile(File(folder, "a.bag").apply { writeText("") }, output))
        BadLog.createTopicDouble("A", "ul", { 1.0 })
        log.finishInitialization()
        loop(log)
        log.close()
        log.counters()
    }

    test("an endless sync delays neither a row nor the end") {
        val disk = HeldDevice()
        val output = SlowOutput(sync = disk::hold)
        val counters = logTo(output, TestTime()) { log ->
            disk.awaitHold()
            repeat(500) { log.row() }
        }
        counters.rowsWritten shouldBe 500
        disk.isWaitedFor shouldBe false
        disk.release()
    }

    test("slow writes are counted, including failed ones and the header") {
        val time = TestTime()
        val slow = SlowOutput(
            append = {
                time.stall(6)
                throw IOException("full")
            },
            finish = { time.stall(6) },
        )
        standardErrorOf {
            val counters = logTo(slow, time) { it.row() }
            // The header is tried at the start and at the end; the end itself is one more.
            slow.appends.get() shouldBe 2
            counters.slowWrites shouldBe 3
            counters.rowsMissed shouldBe 1
        }
    }

    test("a write that takes no longer than 5 ms is not a slow one, and counts towards the slowest row") {
        val time = TestTime()
        var millis = 0L
        val counters = logTo(SlowOutput(append = { time.stall(millis) }), time) { log ->
            for (next in listOf(2L, 5L, 1L)) {
                millis = next
                log.row()
            }
        }
        counters.slowWrites shouldBe 0
        counters.slowestRowNanos shouldBe 5_000_000
    }

    test("after a failed write, the next one waits a quarter of a second") {
        val time = TestTime()
        var isFull = false
        val output = SlowOutput(append = { if (isFull) throw IOException("full") })
        standardErrorOf {
            val counters = logTo(output, time) { log ->
                isFull = true
                repeat(1000) { log.row() }
                output.appends.get() shouldBe 2
                time.pass(249)
                repeat(1000) { log.row() }
                output.appends.get() shouldBe 2
                time.pass(1)
                repeat(1000) { log.row() }
                output.appends.get() shouldBe 3
                isFull = false
                time.pass(250)
                log.row()
                output.appends.get() shouldBe 4
            }
            counters.rowsMissed shouldBe 3000
            counters.rowsWritten shouldBe 1
        }
    }

    test("a file that cannot be closed is reported, and nothing is thrown") {
        standardErrorOf {
            val session = LogSession(flushesEachRow = true)
            session.logTo(LogFile(File("none"), SlowOutput(close = { throw IOException("gone") })))
            BadLog.start(session).close()
        } shouldContain "could not be closed"
    }

    test("a disk is synced four times a second while rows are written, and for the header and the end") {
        val time = TestTime()
        var isClosed = false
        val output = SlowOutput(close = { isClosed = true })
        logTo(output, time) { log ->
            time.settle()
            output.syncs.get() shouldBe 1
            repeat(100) {
                time.pass(10)
                log.row()
            }
            // A row is synced at the end of its quarter; the last one waits.
            output.syncs.get() shouldBe 5
            time.pass(250)
            output.syncs.get() shouldBe 6
            time.pass(1000)
            output.syncs.get() shouldBe 6
        }
        time.awaitEnd()
        isClosed shouldBe true
        output.syncs.get() shouldBe 7
    }
})
