package badlog.page

import badlog.core.bag.BagTopic
import badlog.exporter.EmptyPage
import badlog.exporter.PageNetwork
import badlog.web.LogServerOptions
import io.kotest.core.annotation.Tags
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.collections.shouldContainExactlyInAnyOrder
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.nio.file.Files
import java.nio.file.Path
import java.nio.file.attribute.FileTime
import java.util.function.BooleanSupplier
import kotlin.io.path.copyTo
import kotlin.io.path.createDirectories
import kotlin.io.path.div
import kotlin.io.path.moveTo
import kotlin.io.path.readText
import kotlin.io.path.setLastModifiedTime
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText

/** The page that a web server on a robot serves. */
@Tags("InCheck")
internal class ServedPageSpec : PageSpec({
    val temporary by lazy { Files.createTempDirectory("badlog-served") }
    val bag = bagOf(listOf(TIME, BagTopic("Volts", "V")), rows = 21) { row, column -> if (column == 0) row / 10.0 else row }

    afterSpec { temporary.toFile().deleteRecursively() }

    fun folder(name: String, fill: (Path) -> Unit): Path = (temporary / name).createDirectories().also(fill)

    fun logs(name: String) = folder("$name/logs") { folder ->
        SAMPLES.resolve("qualification-42.bag").copyTo(folder / "FRC_20260307_140212_OHCL_Q42.bag")
        SAMPLES.resolve("qualification-57.bag.gz").copyTo(folder / "FRC_20260307_163005_OHCL_Q57.bag.gz")
        (folder / "bench.bag").writeBytes(bag)
        (folder / "notes.txt").writeText("not a log")
        (folder / "pit 2").createDirectories()
        (folder / "pit 2" / "<img src=x onerror=alert(1)> #1%.bag").writeBytes(bag)
        (folder / "pit 2" / "<img src=x onerror=alert(1)> #1%.bag").setLastModifiedTime(FileTime.fromMillis(1_772_700_000_000))
        (folder / "bench.bag").setLastModifiedTime(FileTime.fromMillis(1_772_600_000_000))
    }

    fun OpenPage.column(name: String) = texts("[data-path] .$name")

    fun OpenPage.openRow(row: Int) = openListed(listedLogs[row])

    fun OpenPage.awaitLog(title: String) {
        await("the log $title") { texts(".page-title h1").singleOrNull()?.contains(title) == true }
        awaitState("ready")
    }

    fun OpenPage.awaitList() = await("the list") { elements(".log-table").isNotEmpty() }

    test("the page for a server differs from the plain one only in that it may use its server") {
        val pages = folder("pages") {}
        EmptyPage().write(pages / "badlog.html")
        EmptyPage().write(pages / "logs.html", PageNetwork.ROBOT)
        val plain = (pages / "badlog.html").readText()
        val served = (pages / "logs.html").readText()
        plain.contains("connect-src") shouldBe false
        served.replace(" connect-src 'self';", "").replace(",\"network\":\"robot\"", "") shouldBe plain
        served.length - plain.length shouldBe " connect-src 'self';,\"network\":\"robot\"".length
    }

    browserTest("a phone in the robot’s network lists its logs, opens, searches and compares them, and gives the reason if the robot sends none") {
        val options = LogServerOptions()
        withRobot(logs("robot"), options) { address ->
            onServedPage(address, Screen.PHONE, says = listOf("status of 503")) {
                step("a phone in the robot's network lists its logs, newest first, and opens one with its findings by a tap") {
                    awaitList()
                    texts(".page-head h1") shouldContainExactly listOf("Robot 127.0.0.1")
                    column("MATCH").take(2) shouldContainExactly listOf("Q57 · OHCL", "Q42 · OHCL")
                    listedLogs.size shouldBe 4
                    listedLogs shouldContain "<img src=x onerror=alert(1)> #1%.bag"
                    listedLogs.last() shouldBe "bench.bag"
                    texts(".log-tools [role=status]").single() shouldBe "4 logs"
                    elements(".log-table img").size shouldBe 0
                    for (screen in listOf(Screen.WIDE.copy(isDark = true), Screen.PHONE)) {
                        show(screen)
                        seriousForReaders() shouldBe emptyList()
                        (number("return document.documentElement.scrollWidth - innerWidth") <= 0) shouldBe true
                        keepScreenshot("served-${screen.width}-${if (screen.isDark) "dark" else "light"}")
                    }
                    openRow(1)
                    awaitLog("Qualification 42")
                    text shouldContain "Likely cause: the robot drew more than its battery gives."
                    val bytes = saved("FRC_20260307_140212_OHCL_Q42.bag") { click("#download") }
                    bytes shouldBe SAMPLES.resolve("qualification-42.bag").toFile().readBytes()
                    click("#go-back")
                    awaitList()
                    await("what was opened to be read") { "6.73 V" in column("BATTERY") }
                    openListed("img")
                    awaitLog("<img src=x onerror=alert(1)> #1%.bag")
                }
                click("#go-back")
                step("while the robot is enabled, the page gives the reason for a refused log, and the back button leads to the list") {
                    awaitList()
                    options.isEnabled = BooleanSupplier { true }
                    openListed("Q57")
                    awaitState("failed")
                    text shouldContain "FRC_20260307_163005_OHCL_Q57.bag.gz cannot be opened"
                    text shouldContain "The robot is enabled: its logs can be opened once it is disabled."
                    options.isEnabled = BooleanSupplier { false }
                    click("#go-back")
                    awaitList()
                }
                show(Screen.WIDE)
                step("checked logs are fetched and drawn over each other; the list can be searched and sorted like a folder's") {
                    awaitList()
                    // This screen has no room for the column.
                    script("const s = document.querySelector('.sort'); s.selectedIndex = [...s.options].findIndex(o => o.text == 'Size ↓'); s.dispatchEvent(new Event('change'))")
                    listedLogs.first() shouldContain "Q42"
                    element("#search").sendKeys("q57")
                    settle()
                    listedLogs shouldContainExactly listOf("FRC_20260307_163005_OHCL_Q57.bag.gz")
                    element("#search").clear()
                    element("#search").sendKeys("ohcl")
                    settle()
                    for (name in listedLogs) click("[aria-label='Compare $name']")
                    click("#compare-logs")
                    awaitLog("Qualification 42")
                    await("both") { texts(".compared-log .cut-name") == listOf("Qualification 42", "Qualification 57") }
                }
                click("#go-back")
                awaitList()
                step("a robot that does not answer is reported") {
                    script("const box = document.querySelector('#search'); box.value = ''; box.dispatchEvent(new Event('input'))")
                    await("the whole list") { listedLogs.size == 4 }
                    script("window.fetch = () => Promise.reject(new TypeError('Failed to fetch'))")
                    openListed("bench")
                    awaitState("failed")
                    text shouldContain "The robot does not answer: stay on its Wi-Fi, and try again."
                }
            }
        }
    }

    browserTest("a match compared with the previous one fetches that one if only its summary is stored") {
        val logs = folder("compared/logs") { for ((name, bytes) in UNLIKE_MATCHES) (it / name).writeBytes(bytes) }
        withRobot(logs) { address ->
            onServedPage(address) {
                awaitList()
                press("i")
                texts(".is-large strong") shouldContainExactly listOf("Not read yet")
                press("i")
                for (name in UNLIKE_MATCHES.keys) click("[aria-label='Compare $name']")
                click("#compare-logs")
                awaitState("ready")
                click("#go-back")
                awaitList()
                await("all of them to be read, and rules to have run over them") {
                    column("DURATION").count { it.isNotEmpty() } == UNLIKE_MATCHES.size && "read" !in texts(".log-tools [role=status]").single()
                }
                awaitKept()
                driver.navigate().refresh()
                awaitState("empty")
                awaitList()
                await("what was in them") { column("DURATION").count { it.isNotEmpty() } == UNLIKE_MATCHES.size }
                openListed("Q8.bag")
                awaitLog("Qualification 8")
                await("how it is unlike those before") { elements(".changes button").isNotEmpty() }
                texts(".changes li").single() shouldBe "Arm/Current while enabled was 21.5 A, 97 % above your 7 other matches (usually 10.9 A)."
                seriousForReaders().shouldBeEmpty()
                click(".changes button")
                await("both") { texts(".compared-log .cut-name") == listOf("Qualification 8", "Qualification 7") }
            }
        }
    }

    browserTest("a log that the robot has finished is fetched, and announced with its worst finding") {
        val logs = folder("arriving/logs") { (it / "bench.bag").writeBytes(bag) }
        withRobot(logs) { address ->
            onServedPage(address, Screen.PHONE) {
                awaitList()
                // The page requests the list again every 15 s, starting when the list is shown.
                script("const set = window.setTimeout; window.keepsTime = true; window.setTimeout = (work, delay, ...more) => set(work, Math.min(delay, 200), ...more)")
                passTime()
                for (isShown in listOf(false, true)) {
                    openRow(0)
                    awaitLog("bench.bag")
                    if (isShown) continue
                    click("#go-back")
                    awaitList()
                }
                // Complete at once, because half a log that is no longer written would be announced as well.
                SAMPLES.resolve("qualification-42.bag").copyTo(logs / "new.part").moveTo(logs / "FRC_20260307_140212_OHCL_Q42.bag")
                await("the news") { texts(".arrival p").single() != "" }
                texts(".arrival p").single() shouldContain "Qualification 42 arrived: "
                texts(".arrival p").single() shouldContain "Browned out at 1:3"
                texts(".page-title h1") shouldContainExactly listOf("bench.bag")
                keepScreenshot("served-arrival-phone")
                click("#show-arrival")
                awaitLog("Qualification 42")
                click("#go-back")
                awaitList()
                await("what is known of both") { listedLogs.size == 2 && "6.73 V" in column("BATTERY") }
            }
        }
    }

    browserTest("a robot enabled during a download is reported as that, not as lost Wi-Fi") {
        val options = LogServerOptions()
        val folder = folder("broken/logs") {
            // The server sends it for some seconds.
            val long = bagOf(listOf(TIME, BagTopic("Volts", "V")), rows = 600_000) { row, column -> if (column == 0) row / 10.0 else row }
            (it / "long.bag").writeBytes(long)
        }
        withRobot(folder, options) { address ->
            onServedPage(address, says = listOf("status of 503", "ERR_")) {
                awaitList()
                openRow(0)
                await("a part") { script("return parseFloat(document.querySelector('.progress-bar')?.style.width || '0') > 0") as Boolean }
                options.isEnabled = BooleanSupplier { true }
                awaitState("failed")
                text shouldContain "The robot is enabled: its logs can be opened once it is disabled."
            }
        }
    }

    browserTest("a robot without logs is reported, and so is a page called index.html, which hides the list") {
        val empty = folder("none/logs") {}
        withRobot(empty) { address ->
            onServedPage(address, state = "failed") { text shouldContain "There are no logs on this robot" }
        }
        val logs = logs("hidden")
        EmptyPage().write(logs / "index.html", PageNetwork.ROBOT)
        WpilibServer(logs).use { server ->
            onServedPage(server.addressOf(""), state = "failed") { text shouldContain "this page must not be called index.html there" }
        }
    }

    browserTest("the same page lists and opens logs that WPILib's own server serves") {
        val logs = logs("wpilib")
        EmptyPage().write(logs / EmptyPage.SERVED_NAME, PageNetwork.ROBOT)
        WpilibServer(logs).use { server ->
            onServedPage(server.addressOf(EmptyPage.SERVED_NAME), Screen.PHONE) {
                awaitList()
                column("MATCH").take(2) shouldContainExactly listOf("Q57 · OHCL", "Q42 · OHCL")
                listedLogs.drop(2) shouldContainExactlyInAnyOrder listOf("bench.bag", "<img src=x onerror=alert(1)> #1%.bag")
                // Their times are unknown.
                column("DATE").drop(2) shouldContainExactly listOf("", "")
                keepScreenshot("served-wpilib-phone")
                openListed("img")
                awaitLog("<img src=x onerror=alert(1)> #1%.bag")
            }
        }
    }

    browserTest("opened from a disk, the page for a server sends no requests, and opens logs like the plain page") {
        val page = folder("disk") {} / EmptyPage.SERVED_NAME
        EmptyPage().write(page, PageNetwork.ROBOT)
        onPage(page, state = "empty") {
            drop("first.bag" to bag)
            awaitLog("first.bag")
            elements("#open-server").shouldBeEmpty()
        }
    }
})
