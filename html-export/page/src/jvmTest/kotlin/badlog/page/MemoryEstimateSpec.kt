package badlog.page

import badlog.core.bag.BagTopic
import badlog.exporter.EmptyPage
import badlog.files.readRecording
import badlog.formats.LOG_FORMATS
import badlog.formats.wpilog.WpilogWriter
import io.kotest.core.annotation.Tags
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldMatch
import io.kotest.matchers.string.shouldNotContain
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.div
import kotlin.io.path.outputStream
import kotlin.io.path.writeBytes

/** Logs that may need more memory than a browser has. */
@Tags("InCheck")
internal class MemoryEstimateSpec : PageSpec({
    val temporary by lazy { Files.createTempDirectory("badlog-need") }
    val page by lazy { (temporary / EmptyPage.NAME).also { EmptyPage().write(it) } }

    // More than 20 MB of rows, in which two topics are signals. Smaller logs are not estimated.
    val bag by lazy {
        val topics = listOf(TIME, BagTopic("System/Battery Voltage", "V"), BagTopic("System/Enabled")) + List(37) { BagTopic("Arm/Joint $it", "deg") }
        (temporary / "large.bag").also {
            it.writeBytes(
                bagOf(topics, rows = 65_000) { row, column ->
                    when (column) {
                        0 -> row / 50.0
                        1 -> if (row in 5000..5200) 6 else 12
                        2 -> 1
                        else -> 1_000_000 + row * column
                    }
                },
            )
        }
    }
    val wpilog by lazy {
        (temporary / "large.wpilog").also { file ->
            file.outputStream().buffered().use { out -> WpilogWriter(readRecording(bag, LOG_FORMATS)).write { bytes, size -> out.write(bytes, 0, size) } }
        }
    }

    afterSpec { temporary.toFile().deleteRecursively() }

    /** Returns a script that makes the device report [gigabytes] of memory. */
    fun device(gigabytes: String) = "Object.defineProperty(Navigator.prototype, 'deviceMemory', {get: () => $gigabytes})"

    fun OpenPage.choose(file: Path) = element("input[type=file]").sendKeys("$file")

    browserTest("before a log that is too large for the device, the page asks, and offers only the topics that rules use") {
        onPage(page, state = "empty", script = device("0.25")) {
            for (file in listOf(bag, wpilog)) {
                step("${file.fileName}") {
                    choose(file)
                    awaitState("failed")
                    text shouldMatch Regex("(?s).*large.* needs about \\d+ MB of memory.*")
                    keepScreenshot("large-log-asks")
                    click("#open-few")
                    awaitState("ready")
                    text shouldContain "Battery Voltage"
                    text shouldContain "Low battery"
                    text shouldNotContain "Joint"
                    click("#go-back")
                    awaitState("empty")
                }
            }
            step("all topics") {
                choose(bag)
                awaitState("failed")
                click("#open-all")
                awaitState("ready")
                text shouldContain "40 topics"
            }
        }
    }
})
