package badlog.web

import com.sun.management.ThreadMXBean
import io.kotest.core.annotation.Tags
import io.kotest.core.spec.style.FunSpec
import io.kotest.matchers.shouldBe
import io.kotest.matchers.shouldNotBe
import java.io.OutputStream
import java.lang.management.ManagementFactory
import java.nio.channels.FileChannel
import java.nio.file.Files
import kotlin.io.path.deleteExisting
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText

@Tags("InCheck")
class DownloadsSpec : FunSpec({
    test("sending the parts of a log allocates nothing") {
        val file = Files.createTempFile("badlog", ".bag").apply { writeBytes(ByteArray(4_000_000)) }
        val downloads = Downloads(Pace(Long.MAX_VALUE / 1_000_000_000, Clock()), Clock())
        val nowhere = OutputStream.nullOutputStream()
        val mayGoOn = { true }
        val threads = ManagementFactory.getThreadMXBean() as ThreadMXBean
        checkNotNull(downloads.take()).use { download ->
            FileChannel.open(file).use { channel ->
                val least = (1..20).minOf {
                    channel.position(0)
                    val before = threads.getThreadAllocatedBytes(Thread.currentThread().id)
                    download.copy(channel, 4_000_000, nowhere, mayGoOn)
                    threads.getThreadAllocatedBytes(Thread.currentThread().id) - before
                }
                least shouldBe 0
            }
        }
        file.deleteExisting()
    }

    test("several downloads together keep to 1 MB/s") {
        val clock = TestClock(isRunning = true)
        val pace = Pace(1_000_000, clock)
        List(2) { Thread { repeat(10) { pace.await(16_384) } }.apply { start() } }.forEach { it.join() }
        // The first part is free.
        clock.nanos() shouldBe 19 * 16_384_000L
    }

    test("unused time is not made up for") {
        val clock = TestClock(isRunning = true)
        val pace = Pace(1_000_000, clock)
        pace.await(16_384)
        clock.advance(seconds = 60)
        repeat(2) { pace.await(16_384) }
        clock.nanos() shouldBe 60_000_000_000 + 16_384_000
    }

    test("a new request gets the place of a download that stood still for ten seconds") {
        val clock = TestClock(isRunning = true)
        withServer(LogServerOptions().also { it.clock = clock }) { server ->
            // More than the system buffers for a client that does not read.
            server.logs.resolve("large.bag").writeBytes(ByteArray(30_000_000))
            server.logs.resolve("small.bag").writeText("small")
            val asleep = List(2) {
                server.connect().apply {
                    getOutputStream().write("GET /logs/large.bag HTTP/1.1\r\nHost: localhost\r\n\r\n".encodeToByteArray())
                    getInputStream().read() shouldNotBe -1
                }
            }
            clock.advance(seconds = 9)
            server.get("/logs/small.bag").status shouldBe 503
            awaited("a place") {
                // The system's buffer may still be filling.
                clock.advance(seconds = 11)
                server.get("/logs/small.bag").takeIf { it.status == 200 }
            }.text shouldBe "small"
            asleep.forEach { it.close() }
        }
    }
})
