package badlog.page

import badlog.core.bag.BagTopic
import badlog.exporter.EmptyPage
import io.kotest.core.annotation.Tags
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldMatch
import java.nio.channels.FileChannel
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.StandardOpenOption
import kotlin.io.path.createDirectories
import kotlin.io.path.div
import kotlin.io.path.writeBytes

/** Folders and files with unexpected content or behavior. */
@Tags("InCheck")
internal class HostileFolderSpec : PageSpec({
    val temporary by lazy { Files.createTempDirectory("badlog-hostile") }
    val page by lazy { (temporary / EmptyPage.NAME).also { EmptyPage().write(it) } }
    val bag = bagOf(listOf(TIME, BagTopic("Volts", "V")), rows = 21) { row, column -> if (column == 0) row / 10.0 else row }

    afterSpec { temporary.toFile().deleteRecursively() }

    fun folder(name: String, fill: (Path) -> Unit): Path = (temporary / name).createDirectories().also(fill)

    fun OpenPage.choose(folder: Path) {
        elements("input[type=file]").last().sendKeys("$folder")
        await("the list") { elements(".log-table").isNotEmpty() }
    }

    fun OpenPage.status() = texts(".log-tools [role=status]").single()

    browserTest("a folder of 3,000 logs is listed at once; a folder that disappears and a log that shrinks are reported") {
        step("a folder of 3,000 files is listed at once and can be searched while its logs are read") {
            val many = folder("many") { folder -> repeat(3_000) { Files.write(folder / "practice-$it.bag", bag) } }
            // Workers receive nothing until they are released.
            val waiting = """
                window.held = [];
                window.Worker = class extends Worker {
                    postMessage(...work) { held ? held.push(() => super.postMessage(...work)) : super.postMessage(...work) }
                }
            """
            onPage(page, state = "empty", script = waiting) {
                choose(many)
                status() shouldMatch Regex("0 of 3.?000 logs read")
                (listedLogs.size < 150) shouldBe true
                element("#search").sendKeys("practice-2999")
                await("the one") { listedLogs == listOf("practice-2999.bag") }
                script("for (const work of held) work(); held = null")
                openListed("2999")
                awaitState("ready")
                click("#go-back")
                awaitState("empty")
            }
        }
        step("logs of a folder that disappears are reported as unreadable, and the page continues") {
            val gone = folder("gone") { folder -> repeat(40) { Files.write(folder / "$it.bag", bag) } }
            onPage(page, state = "empty", script = "window.Worker = class { constructor() { throw new Error() } }") {
                choose(gone)
                gone.toFile().deleteRecursively()
                await("all logs") { "read" !in status() }
                elements("tbody .MATCH button").last().click()
                awaitState("failed")
                text shouldContain "cannot be read"
                click("#go-back")
                awaitState("empty")
                status() shouldBe "40 logs"
            }
        }
        step("a log that shrinks after it was chosen is reported as unreadable") {
            val file = (temporary / "shrinks.bag").also { it.writeBytes(bag) }
            onPage(page, state = "empty") {
                element("input[type=file]").sendKeys("$file")
                awaitState("ready")
                click("#go-back")
                awaitState("empty")
                // The dialog gives the page the current file, which becomes shorter before it is read.
                script(
                    "window.Worker = class { constructor() { throw new Error() } }; window.waits = true; const read = Blob.prototype.arrayBuffer;" +
                        "Blob.prototype.arrayBuffer = async function () { while (window.waits) await new Promise(d => setTimeout(d)); return read.call(this) }",
                )
                element("input[type=file]").sendKeys("$file")
                FileChannel.open(file, StandardOpenOption.WRITE).use { it.truncate(40) }
                script("window.waits = false")
                awaitState("failed")
                text shouldContain "shrinks.bag cannot be read"
                click("#go-back")
                awaitState("empty")
            }
        }
    }
})
