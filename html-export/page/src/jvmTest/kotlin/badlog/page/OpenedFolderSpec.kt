package badlog.page

import badlog.core.bag.BagTopic
import badlog.exporter.EmptyPage
import io.kotest.core.annotation.Tags
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldStartWith
import org.openqa.selenium.Keys
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.copyTo
import kotlin.io.path.createDirectories
import kotlin.io.path.deleteExisting
import kotlin.io.path.div
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText

/** A folder of logs, opened on a page. */
@Tags("InCheck")
internal class OpenedFolderSpec : PageSpec({
    val temporary by lazy { Files.createTempDirectory("badlog-folder") }
    val page by lazy { (temporary / EmptyPage.NAME).also { EmptyPage().write(it) } }
    val bag = bagOf(listOf(TIME, BagTopic("Volts", "V")), rows = 21) { row, column -> if (column == 0) row / 10.0 else row }

    afterSpec { temporary.toFile().deleteRecursively() }

    fun folder(name: String, fill: (Path) -> Unit): Path = (temporary / name).createDirectories().also(fill)

    fun samples() = folder("event") { folder ->
        for (sample in listOf("qualification-42.bag", "qualification-57.bag.gz", "practice.bag", "elevator-bench.csv", "README.md")) {
            SAMPLES.resolve(sample).copyTo(folder / sample, overwrite = true)
        }
        (folder / "day2").createDirectories()
        (folder / "day2" / "pit.bag").writeBytes(bag)
    }

    fun OpenPage.awaitAll() = await("all logs") { texts(".log-tools [role=status]").single().let { "read" !in it } }

    fun OpenPage.open(folder: Path) {
        elements("input[type=file]").last().sendKeys("$folder")
        await("the list") { elements(".log-table").isNotEmpty() }
    }

    /** Opens [folder] on the page without a log. */
    fun onFolder(folder: Path, test: OpenPage.() -> Unit) = onPage(page, state = "empty") {
        open(folder)
        test()
    }

    /** Opens the page again, with another [folder]. */
    fun OpenPage.openAnew(folder: Path) {
        startOver("empty")
        open(folder)
        awaitAll()
    }

    /** Shows the list without a search. */
    fun OpenPage.backToList(isOpen: Boolean = true) {
        if (isOpen) click("#go-back")
        await("the list’s search") { elements("#search").isNotEmpty() }
        script("const box = document.querySelector('#search'); box.value = ''; box.dispatchEvent(new Event('input'))")
        await("the list") { elements(".log-table").isNotEmpty() }
        awaitAll()
    }

    fun OpenPage.column(name: String) = texts("[data-path] .$name")

    fun OpenPage.awaitLog(title: String) {
        await("the log $title") { texts(".page-title h1").singleOrNull()?.contains(title) == true }
        awaitState("ready")
    }

    browserTest("a folder and its subfolders are a list of logs, from which each is opened, compared and left again") {
        onFolder(samples()) {
            step("a folder and its subfolders are listed as in the window, with match, battery and findings, but without other files") {
                texts(".page-head h1") shouldContainExactly listOf("event")
                listedLogs.size shouldBe 5
                awaitAll()
                press(Keys.TAB, Keys.ENTER)
                script("return document.activeElement.closest('tr') === document.querySelector('[data-path]')") shouldBe true
                listedLogs shouldContainExactlyInAnyOrder
                    listOf("qualification-42.bag", "qualification-57.bag.gz", "practice.bag", "elevator-bench.csv", "pit.bag")
                val row = listedLogs.indexOf("qualification-42.bag")
                column("MATCH")[row] shouldBe "Q42 · Mill Creek"
                column("BATTERY")[row] shouldBe "6.73 V"
                column("FINDINGS")[row] shouldStartWith "errorBrowned out at 1:3"
                texts(".battery-table tbody .battery") shouldContainExactly listOf("B3, 2019", "B9, 2023")
                // B3 browned out in qualification 42.
                texts(".battery-table h3") shouldBe listOf("Use B9, 2023 next")
                seriousForReaders() shouldBe emptyList()
                keepScreenshot("folder")
                show(Screen.WIDE.copy(isDark = true))
                keepScreenshot("folder-dark")
                show(Screen.PHONE)
                (number("return document.documentElement.scrollWidth - innerWidth") <= 0) shouldBe true
                keepScreenshot("phone-folder")
            }
            show(Screen.WIDE)
            step("a click on a title sorts, words search, and checked logs are drawn over each other") {
                click("th.BATTERY button")
                column("BATTERY").first() shouldBe "6.73 V"
                click("th.BATTERY button")
                column("BATTERY")[0] shouldContain "V"
                (column("BATTERY")[0] != "6.73 V") shouldBe true
                element("#search").sendKeys("mill 57")
                settle()
                listedLogs shouldContainExactly listOf("qualification-57.bag.gz")
                element("#search").sendKeys(" nothing")
                settle()
                text shouldContain "No log matches “"
                element("#search").sendKeys(Keys.chord(Keys.CONTROL, "a"), "qualification")
                settle()
                element("#compare-logs").isEnabled shouldBe false
                for (name in listOf("qualification-42.bag", "qualification-57.bag.gz")) click("[aria-label='Compare $name']")
                click("#compare-logs")
                awaitLog("Qualification 42")
                await("both") { texts(".compared-log .cut-name") == listOf("Qualification 42", "Qualification 57") }
            }
            backToList()
            step("a finding in the list opens its log at the worst incident; the next log and the list are a click away") {
                click("th.MATCH button")
                click("td.FINDINGS button") { "Browned out" in it.text }
                awaitLog("Qualification 42")
                await("its evidence") { elements(".evidence").any { it.isDisplayed } }
                text shouldContain "Likely cause"
                script("location.hash = '#t=93.7'")
                click("#next-log")
                awaitLog("Qualification 57")
                script("return location.hash") shouldBe ""
                click("#previous-log")
                awaitLog("Qualification 42")
                click("#go-back")
                await("the list") { elements(".log-table").isNotEmpty() }
                awaitAll()
                listedLogs.size shouldBe 5
            }
            step("the back button leads to the row of the log; keys in a dialog do not switch logs") {
                script("document.querySelector(\"[data-path='event/practice.bag'] button\").focus()")
                press(Keys.ENTER)
                await("the log") { texts(".page-title h1").size == 1 }
                awaitState("ready")
                script("return document.activeElement.tagName") shouldBe "MAIN"
                for ((step, screen) in listOf("back" to "empty", "back" to "empty", "forward" to "empty", "forward" to "ready")) {
                    script("history.$step()")
                    awaitState(screen)
                }
                await("the log again") { texts(".page-title h1").singleOrNull() == "practice.bag" }
                press("m")
                act { keyDown(Keys.ALT).sendKeys(Keys.PAGE_DOWN).keyUp(Keys.ALT) }
                press(Keys.ESCAPE)
                texts(".page-title h1").size shouldBe 1
                click("#go-back")
                await("the list") { elements(".log-table").isNotEmpty() }
                script("return document.activeElement.textContent") shouldBe "practice.bag"
                elements("#theme").size shouldBe 1
                script("return document.documentElement.dataset.rules ?? null") shouldBe null
                // The folder's own name matches nothing.
                element("#search").sendKeys("event practice")
                settle()
                text shouldContain "No log matches “"
            }
            backToList(isOpen = false)
            step("after a file that cannot be shown, another one can be dropped, and the list is still there") {
                drop("pit.zip" to byteArrayOf(1, 2, 3))
                awaitState("failed")
                drop("pit.jpg" to byteArrayOf(-1, -40, -1, 0, 0, 16))
                await("the other sentence") { "nothing to show in pit.jpg" in text }
                click("#go-back")
                await("the list") { elements(".log-table").isNotEmpty() }
                awaitAll()
                drop("alone.bag" to bag)
                awaitLog("alone.bag")
                click("#go-back")
                awaitState("empty")
                text shouldContain "Open a robot’s log"
            }
        }
    }

    browserTest("unusual folders, opened or dropped, are listed, and their logs are opened") {
        step("unusual folders are listed, and their logs are opened") {
            val days = folder("days") { folder ->
                for ((day, volts) in listOf("day1" to 11, "day2" to 12, "day3" to 13)) {
                    val log = bagOf(listOf(TIME, BagTopic("Volts", "V")), rows = 21) { row, column -> if (column == 0) row / 10.0 else volts + row % 2 }
                    (folder / day).createDirectories()
                    (folder / day / "match.bag").writeBytes(log)
                    (folder / day / "._match.bag").writeBytes(byteArrayOf(1, 2, 3))
                }
            }
            val tables = folder("tables") { folder ->
                val rows = (0..1500).joinToString("\n") { i -> "${i / 50.0},${if (i in 500..700) 6.2 else 12.4},1" }
                (folder / "a.csv").writeText("Time,Battery Voltage,Enabled\n$rows\n")
                (folder / "b.bag").writeBytes(bag)
            }
            val gone = folder("hostile") { folder ->
                (folder / "<img src=x onerror=alert(1)>.bag").writeBytes(bag)
                (folder / "damaged.bag").writeText("{\"topics\":[")
                (folder / "groceries.csv").writeText("milk,2\neggs,12\n")
                (folder / "empty.wpilog").writeBytes(ByteArray(0))
                (folder / "packed.bag").writeBytes(byteArrayOf(0xfd.toByte(), 0x37, 0x7a, 0x58, 0x5a, 0, 1, 2))
            }
            val shrinking = folder("shrinking") { folder ->
                (folder / "a.bag").writeBytes(bag)
                (folder / "b.bag").writeBytes(bag)
            }
            val many = folder("many") { folder -> for (i in 1..350) (folder / "FRC_20260314_100000_TEST_Q$i.bag").writeText("{\"topics\":[],\"values\":[]}\n\n") }
            onFolder(days) {
                step("logs of the same name in different folders can be compared, and hidden files are not listed") {
                    awaitAll()
                    listedLogs.size shouldBe 3
                    for (box in elements("[aria-label='Compare match.bag']").indices) elements("[aria-label='Compare match.bag']")[box].click()
                    click("#compare-logs")
                    await("all three") { texts(".compared-log .cut-name").size == 3 }
                    texts(".compared-log .cut-name").distinct().size shouldBe 3
                }
                openAnew(tables)
                step("a finding in a table without an x axis opens over the time column, in which it was found") {
                    val named = elements("td.FINDINGS button").first().text.substringBefore(" at ")
                    click("td.FINDINGS button")
                    awaitLog("a.csv")
                    await("its evidence") { elements(".evidence").any { it.isDisplayed } }
                    text shouldContain named
                }
                openAnew(gone)
                step("unreadable files are listed with the reason, and hostile names stay text") {
                    listedLogs shouldContain "<img src=x onerror=alert(1)>.bag"
                    elements(".log-table img").size shouldBe 0
                    fun cell(name: String, file: String) = column(name)[listedLogs.indexOf(file)]
                    cell("PROBLEMS", "packed.bag") shouldBe "errorunreadable"
                    cell("FINDINGS", "packed.bag") shouldBe "cannot be read"
                    cell("FINDINGS", "empty.wpilog") shouldBe "no samples"
                    openListed("img")
                    awaitLog("<img src=x onerror=alert(1)>.bag")
                }
                openAnew(shrinking)
                step("a log that was deleted before it is opened is reported, and the back button leads to the list") {
                    (shrinking / "b.bag").deleteExisting()
                    openListed("b.bag")
                    awaitState("failed")
                    text shouldContain "b.bag cannot be read"
                    click("#go-back")
                    await("the list") { elements(".log-table").isNotEmpty() }
                }
                startOver("empty")
                open(many)
                step("a table of very many logs has enough rows for the screen at first, and more as a person scrolls") {
                    val first = listedLogs.size
                    (first < 150) shouldBe true
                    script("scrollTo(0, document.body.scrollHeight)")
                    await("more rows") { listedLogs.size > first }
                    column("MATCH").first() shouldStartWith "Q"
                    script("document.querySelector('th.MATCH button').click()")
                    number("return document.querySelector('.log-table').getBoundingClientRect().top") shouldBe 0.0
                    listedLogs.size shouldBe first
                }
            }
        }
        step("a dropped folder is listed with its subfolders, although browsers list it in parts; names may repeat") {
            onPage(page, state = "empty") {
                script(
                    """
                    const bytes = Uint8Array.from(arguments[0])
                    const file = path => ({isFile: true, fullPath: path, file: take => take(new File([bytes], path.split('/').pop()))})
                    const folder = (path, ...parts) => ({isDirectory: true, fullPath: path, createReader: () => ({readEntries: take => take(parts.shift() ?? [])})})
                    const day2 = folder('/event/day2', [file('/event/day2/a.bag')])
                    const event = folder('/event', [file('/event/a.bag'), file('/event/b.bag')], [day2, file('/event/notes.txt')])
                    const drop = new Event('drop', {bubbles: true, cancelable: true})
                    drop.dataTransfer = {types: ['Files'], files: {length: 0, item: () => null}, items: [{webkitGetAsEntry: () => event}]}
                    document.body.dispatchEvent(drop)
                    """.trimIndent(),
                    bag.map { it.toInt() and 255 },
                )
                await("the list") { elements(".log-table").isNotEmpty() }
                texts(".page-head h1") shouldContainExactly listOf("event")
                awaitAll()
                texts("tbody .MATCH") shouldContainExactlyInAnyOrder listOf("a.bag", "b.bag", "day2/a.bag")
            }
            onPage(page, state = "empty") {
                drop(samples().also { page.copyTo(it / "page.html", overwrite = true) })
                await("the list") { elements(".log-table").isNotEmpty() }
                awaitAll()
                texts(".log-tools [role=status]") shouldContainExactly listOf("5 logs · 1 page left out: open one alone")
            }
            onPage(page, state = "empty") {
                drop("a.bag" to bag, "a.bag" to bag)
                await("the list") { elements(".log-table").isNotEmpty() }
                awaitAll()
                listedLogs shouldContainExactlyInAnyOrder listOf("a.bag", "a.bag (2)")
            }
        }
    }
})
