package badlog.page

import badlog.files.gzip
import badlog.formats.driverstation.STATION_EVENTS
import badlog.formats.driverstation.STATION_LOG
import io.kotest.core.annotation.Tags
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.nio.file.Files

@Tags("InCheck")
internal class DownloadSpec : PageSpec({
    fun csvOf(bag: ByteArray) = bag.copyOfRange(bag.indexOf('\n'.code.toByte()) + 1, bag.size)

    fun OpenPage.downloaded(id: String, name: String) = saved(name) { click("#$id") }

    val whole by lazy { Files.readAllBytes(SAMPLES.resolve("qualification-42.bag")) }

    browserTest("each log is saved byte for byte, and as CSV") {
        step("a gzip file of several members is saved whole, and its CSV has the rows of all members") {
            val (one, other) = whole.copyOf(200_000) to whole.copyOfRange(200_000, whole.size)
            val packed = gzip(one) + gzip(other)
            onPage(TestPages.of(packed, "members.bag.gz")) {
                downloaded("download", "members.bag.gz") shouldBe packed
                downloaded("download-csv", "members.bag.gz.csv") shouldBe csvOf(whole)
            }
        }
        step("both files of a Driver Station log are saved byte for byte, and a table of it") {
            val (log, events) = gzip(STATION_LOG.bytes) to gzip(STATION_EVENTS.bytes)
            onPage(TestPages.ofPair("station.dslog.gz" to log, "station.dsevents.gz" to events)) {
                texts("#download").single() shouldBe ".dslog"
                texts("#download-second").single() shouldBe ".dsevents"
                downloaded("download", "station.dslog.gz") shouldBe log
                downloaded("download-second", "station.dsevents.gz") shouldBe events
                val lines = downloaded("download-csv", "station.dslog.gz.csv").decodeToString().trimEnd().lines()
                lines.first() shouldContain "Battery"
                lines.size shouldBeGreaterThan 2
            }
        }
    }
})
