package badlog.page

import badlog.core.bag.BagTopic
import badlog.exporter.EmptyPage
import io.kotest.core.annotation.Tags
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.div
import kotlin.io.path.writeBytes

/** The page's actions on the logs of a folder besides opening them. */
@Tags("InCheck")
internal class FolderToolsSpec : PageSpec({
    val temporary by lazy { Files.createTempDirectory("badlog-folder") }
    val page by lazy { (temporary / EmptyPage.NAME).also { EmptyPage().write(it) } }

    afterSpec { temporary.toFile().deleteRecursively() }

    fun log(volts: Int, event: String? = null, match: Int = 1): ByteArray {
        val text = bagOf(listOf(TIME, BagTopic("Volts", "V"), BagTopic("Arm", "m")), rows = 21) { row, column ->
            if (column == 0) row / 10.0 else volts + row % 2
        }.decodeToString()
        if (event == null) return text.encodeToByteArray()
        val values = "\"values\":[{\"name\":\"Event\",\"value\":\"$event\"},{\"name\":\"Match Type\",\"value\":\"Qualification\"},{\"name\":\"Match Number\",\"value\":\"$match\"}]"
        return text.replaceFirst("\"values\":[]", values).encodeToByteArray()
    }

    fun season(): Path = (temporary / "season").createDirectories().also { folder ->
        for ((name, bytes) in listOf(
            "a1.bag" to log(11, "Alpha Regional", 1),
            "b1.bag" to log(12, "Beta District", 1),
            "a2.bag" to log(13, "Alpha Regional", 2),
            "pit.bag" to log(14),
        )) {
            (folder / name).writeBytes(bytes)
        }
    }

    fun OpenPage.choose(folder: Path) {
        elements("input[type=file]").last().sendKeys("$folder")
        await("the list") { elements(".log-table").isNotEmpty() }
        await("all logs") { texts(".log-tools [role=status]").single().let { "read" !in it } }
    }

    fun OpenPage.check(name: String) = click("[aria-label='Compare $name']")

    browserTest("logs of several events are grouped, and the statistics of the checked ones are side by side") {
        onPage(page, state = "empty") {
            step("logs sorted by match are grouped by event") {
                choose(season())
                click("th.MATCH button")
                texts(".row-group span:first-child") shouldContainExactly listOf("Alpha Regional", "Beta District", "No event")
                listedLogs shouldContainExactly listOf("a1.bag", "a2.bag", "b1.bag", "pit.bag")
                seriousForReaders() shouldBe emptyList()
                keepScreenshot("folder-events")
            }
            step("statistics of the checked logs are side by side, topic by topic, and can be searched") {
                element(".log-statistics").isDisplayed shouldBe false
                check("a1.bag")
                check("b1.bag")
                settle()
                script("[...document.querySelectorAll('.log-statistics .statistic button')].find(b => b.textContent === 'max').click()")
                settle()
                texts(".log-statistics tbody th") shouldContainExactly listOf("Time [s]", "Volts [V]", "Arm [m]")
                texts(".log-statistics tbody tr:nth-child(2) td") shouldContainExactly listOf("12", "13")
                element(".log-statistics input").sendKeys("arm")
                settle()
                texts(".log-statistics tbody th") shouldContainExactly listOf("Arm [m]")
                seriousForReaders() shouldBe emptyList()
                keepScreenshot("folder-statistics")
                check("b1.bag")
                show(Screen.PHONE)
                (number("return document.documentElement.scrollWidth - innerWidth") <= 0) shouldBe true
                keepScreenshot("phone-folder-statistics")
            }
        }
    }

    val counting = "window.started = 0; const Original = Worker; window.Worker = function (...all) { window.started++; return new Original(...all) }"

    browserTest("results are known when the page is opened again, where there is storage, and a watched folder shows what changed") {
        step("the results for a folder are known when the page is opened again, without reading the logs") {
            val folder = season()
            onPage(page, state = "empty", script = counting) {
                choose(folder)
                number("return window.started").toInt() shouldBeGreaterThan 0
                val before = texts("td.FINDINGS, tbody .MATCH")
                awaitKept()
                Chromium.driver.navigate().refresh()
                awaitState("empty")
                choose(folder)
                number("return window.started") shouldBe 0.0
                texts("td.FINDINGS, tbody .MATCH") shouldBe before
                // A log that was written again is read again.
                (folder / "pit.bag").writeBytes(log(9) + "2.1,9,9\n".encodeToByteArray())
                Chromium.driver.navigate().refresh()
                awaitState("empty")
                choose(folder)
                number("return window.started").toInt() shouldBeGreaterThan 0
            }
        }
        step("closing the folder dialog without a choice changes nothing; a browser without storage reads the logs each time") {
            val forbidden = "Object.defineProperty(window, 'indexedDB', {get() { throw new Error('forbidden') }});" +
                "window.showDirectoryPicker = async () => { throw new DOMException('', 'AbortError') }"
            onPage(page, state = "empty", script = forbidden) {
                click("#open-folder")
                text shouldContain "Open a robot’s log"
                consoleMessages() shouldBe emptyList()
                choose(season())
                listedLogs.size shouldBe 4
            }
        }
        step("a folder into which the page may look again shows new and grown logs, and no removed ones") {
            onPage(page, state = "empty", script = watchedFolder(mapOf("one.bag" to log(11)))) {
                click("#open-folder")
                await("one log") { listedLogs == listOf("one.bag") }
                texts(".page-head h1") shouldContainExactly listOf("pit")
                script(putIntoFolder(mapOf("one.bag" to log(11) + "2.1,9,9\n2.2,9,9\n".encodeToByteArray(), "two.bag" to log(12), "notes.txt" to byteArrayOf(1))))
                await("both") { listedLogs.sorted() == listOf("one.bag", "two.bag") }
                // A log is read once it has stopped growing, so not at the first look.
                await("what grew") { "2.2 s" in texts("td.DURATION").joinToString() }
                script(putIntoFolder(mapOf("two.bag" to log(12))))
                await("the other alone") { listedLogs == listOf("two.bag") }
            }
        }
    }
})
