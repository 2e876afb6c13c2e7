package badlog.page

import badlog.driverstation.STATION_EVENTS
import badlog.driverstation.STATION_LOG
import badlog.file.gzip
import io.kotest.matchers.shouldBe
import org.openqa.selenium.By
import java.io.ByteArrayOutputStream
import java.io.EOFException
import java.nio.file.Files
import java.nio.file.Path
import java.util.zip.GZIPInputStream
import kotlin.io.path.deleteIfExists
import kotlin.io.path.exists
import kotlin.io.path.readBytes

internal class DownloadSpec : PageSpec({
    fun csvOf(bag: ByteArray) = bag.copyOfRange(bag.indexOf('\n'.code.toByte()) + 1, bag.size)

    /** What the browser stores as [name] when the button [id] is pressed. */
    fun OpenPage.downloaded(id: String, name: String): ByteArray {
        val file = Chromium.downloads.resolve(name)
        file.deleteIfExists()
        click("#$id")
        await("the download $name") { file.exists() && !Path.of("$file.crdownload").exists() }
        return file.readBytes().also { Files.delete(file) }
    }

    val bag by lazy { Files.readAllBytes(SAMPLES.resolve("practice.bag")) }

    browserTest("a cut bag comes back byte for byte, and its CSV is all but its first line") {
        onPage(TestPages.ofSample("practice.bag")) {
            downloaded("download", "practice.bag") shouldBe bag
            downloaded("download-csv", "practice.bag.csv") shouldBe csvOf(bag)
        }
    }

    browserTest("a gzip file comes back byte for byte, and its CSV inflated") {
        val packed = gzip(bag)
        onPage(TestPages.of(packed, "whole.bag.gz")) {
            downloaded("download", "whole.bag.gz") shouldBe packed
            downloaded("download-csv", "whole.bag.gz.csv") shouldBe csvOf(bag)
        }
    }

    browserTest("a gzip file that was never closed comes back byte for byte, and its CSV to the last byte there is") {
        val file = SAMPLES.resolve("qualification-57.bag.gz")
        onPage(TestPages.ofSample("qualification-57.bag.gz")) {
            downloaded("download", "qualification-57.bag.gz") shouldBe Files.readAllBytes(file)
            downloaded("download-csv", "qualification-57.bag.gz.csv") shouldBe
                csvOf(inflatable(Files.readAllBytes(file)))
        }
    }

    browserTest("a gzip file of several members comes back whole, with the rows of all of them") {
        val (one, other) = bag.copyOf(200_000) to bag.copyOfRange(200_000, bag.size)
        val packed = gzip(one) + gzip(other)
        onPage(TestPages.of(packed, "members.bag.gz")) {
            downloaded("download", "members.bag.gz") shouldBe packed
            downloaded("download-csv", "members.bag.gz.csv") shouldBe csvOf(bag)
        }
    }

    listOf<Pair<String, (ByteArray) -> ByteArray>>("" to { it }, ".gz" to ::gzip).forEach { (ending, packed) ->
        browserTest("both files of a Driver Station's log come back byte for byte: .dslog$ending and .dsevents$ending") {
            val (log, events) = packed(STATION_LOG.bytes) to packed(STATION_EVENTS.bytes)
            onPage(TestPages.ofPair("station.dslog$ending" to log, "station.dsevents$ending" to events)) {
                texts("#download").single() shouldBe ".dslog"
                texts("#download-second").single() shouldBe ".dsevents"
                downloaded("download", "station.dslog$ending") shouldBe log
                downloaded("download-second", "station.dsevents$ending") shouldBe events
            }
        }
    }

    browserTest("of a plain CSV file, both are the file itself") {
        val csv = Files.readAllBytes(SAMPLES.resolve("elevator-bench.csv"))
        onPage(TestPages.ofSample("elevator-bench.csv")) {
            downloaded("download", "elevator-bench.csv") shouldBe csv
            downloaded("download-csv", "elevator-bench.csv") shouldBe csv
        }
    }

    browserTest("bytes that are not text come back as they were") {
        val odd = byteArrayOf(-1, -2, 0, 13, 10, -61)
        val bytes = "Time,A\n0,1\n1,".encodeToByteArray() + odd + "\n2,3\n".encodeToByteArray()
        onPage(TestPages.of(bytes, "bytes.bag")) { downloaded("download", "bytes.bag") shouldBe bytes }
    }

    browserTest("a graph can be saved as a picture") {
        onPage(TestPages.ofSample("elevator-bench.csv")) {
            act { moveToElement(graph("Position").scrollTo().card) }
            val file = Chromium.downloads.resolve("Position.png")
            graph("Position").card.findElement(By.cssSelector(".save-image")).click()
            await("the picture") { file.exists() }
            file.readBytes().copyOf(4) shouldBe byteArrayOf(-119, 80, 78, 71)
        }
    }
})

/** What can be inflated from a gzip stream that may be cut off. */
private fun inflatable(packed: ByteArray): ByteArray {
    val out = ByteArrayOutputStream()
    val stream = GZIPInputStream(packed.inputStream())
    try {
        // One byte at a time, so that nothing is lost with the buffer that the end interrupts.
        while (true) {
            val byte = stream.read()
            if (byte < 0) break
            out.write(byte)
        }
    } catch (_: EOFException) {
        return out.toByteArray()
    }
    return out.toByteArray()
}
