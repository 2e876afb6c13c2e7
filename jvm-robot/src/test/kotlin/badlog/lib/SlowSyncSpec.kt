package badlog.lib

import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.ints.shouldBeGreaterThanOrEqual
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.io.File
import java.io.IOException
import java.util.concurrent.CountDownLatch
import java.util.concurrent.atomic.AtomicInteger
import java.util.concurrent.atomic.AtomicReference
import kotlin.concurrent.thread

/** A slow disk: [append], [finish], [sync] and [close] are what its functions do. */
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
    /** The counters of a robot that does [loop] with its log to [output]. */
    fun logTo(output: BagOutput, loop: (BadLog) -> Unit): LogCounters = inFolder { folder ->
        val session = LogSession(flushesEachRow = true)
        val log = BadLog.start(session)
        session.logTo(LogFile(File(folder, "a.bag").apply { writeText("") }, output))
        BadLog.createTopicDouble("A", "ul", { 1.0 })
        log.finishInitialization()
        loop(log)
        log.close()
        log.counters()
    }

    test("a disk that does not end a sync does not delay a row") {
        val isSyncing = CountDownLatch(1)
        val mayEnd = CountDownLatch(1)
        val output = SlowOutput(sync = {
            isSyncing.countDown()
            mayEnd.await()
        })
        val counters = AtomicReference<LogCounters>()
        val robot = thread {
            logTo(output) { log ->
                isSyncing.await()
                repeat(500) { log.row() }
                counters.set(log.counters())
            }
        }
        robot.join(120_000)
        val isDelayed = robot.isAlive
        mayEnd.countDown()
        robot.join()
        isDelayed shouldBe false
        counters.get().rowsWritten shouldBe 500
    }

    test("slow writes are counted, including failed ones and the header") {
        val slow = SlowOutput(
            append = {
                Thread.sleep(10)
                throw IOException("full")
            },
            finish = { Thread.sleep(10) },
        )
        standardErrorOf {
            val counters = logTo(slow) { it.row() }
            // The header is tried at the start, at the end, and for each quarter of a second between; the end itself is one more.
            slow.appends.get() shouldBeGreaterThanOrEqual 2
            counters.slowWrites shouldBe slow.appends.get() + 1
            counters.rowsMissed shouldBe 1
        }
    }

    test("a file that cannot be closed is reported, and nothing is thrown") {
        standardErrorOf {
            val session = LogSession(flushesEachRow = true)
            session.logTo(LogFile(File("none"), SlowOutput(close = { throw IOException("gone") })))
            BadLog.start(session).close()
        } shouldContain "could not be closed"
    }

    test("a fast disk is synced at most four times a second, and for the header") {
        val output = SlowOutput()
        val began = System.nanoTime()
        logTo(output) { log ->
            until({ output.syncs.get() >= 5 }) {
                log.row()
                Thread.sleep(1)
            }
        }
        val quarters = ((System.nanoTime() - began) / 250_000_000).toInt()
        // Also at the start and at the end.
        output.syncs.get() shouldBeLessThanOrEqual quarters + 2
    }
})
