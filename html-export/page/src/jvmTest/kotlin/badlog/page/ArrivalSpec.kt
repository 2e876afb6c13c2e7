package badlog.page

import badlog.core.bag.BagTopic
import badlog.exporter.EmptyPage
import io.kotest.core.annotation.Tags
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.doubles.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldStartWith
import java.nio.file.Files
import kotlin.io.path.div
import kotlin.io.path.readBytes

/** Logs that arrive in a folder into which the page may look again: the announcement, and the view for pits. */
@Tags("InCheck")
internal class ArrivalSpec : PageSpec({
    val temporary by lazy { Files.createTempDirectory("badlog-arrival") }
    val page by lazy { (temporary / EmptyPage.NAME).also { EmptyPage().write(it) } }
    val laptop = Screen(1366, 768)

    afterSpec { temporary.toFile().deleteRecursively() }

    fun samples(vararg names: String) = names.associateWith { SAMPLES.resolve(it).readBytes() }

    /** Returns the log of a minute in which the battery falls to [volts]. */
    fun match(number: Int, volts: Double): ByteArray {
        val topics = listOf(TIME, BagTopic("Enabled", "ul"), BagTopic("Battery Voltage", "V"))
        val values = mapOf("Match Type" to "Qualification", "Match Number" to "$number", "Start Time" to "2026-03-07T10:$number:00")
        return bagOf(topics, rows = 600, values) { row, column ->
            when (column) {
                0 -> row / 10.0
                1 -> "${row > 20}"
                else -> if (row in 330..340) volts else 12.0
            }
        }
    }

    val before = mapOf("practice.bag" to match(40, 11.0), "qualification-41.bag" to match(41, 11.0))
    val after = before + ("qualification-42.bag" to match(42, 6.0))

    fun OpenPage.openFolder() {
        click("#open-folder")
        await("all logs") { texts(".log-tools [role=status]").singleOrNull()?.let { "read" !in it } == true }
    }

    fun OpenPage.awaitLog(title: String) {
        await("the log $title") { texts(".page-title h1").singleOrNull()?.contains(title) == true }
        awaitState("ready")
    }

    fun OpenPage.news() = texts(".arrival p").singleOrNull().orEmpty()

    fun OpenPage.focused() = script("return document.activeElement.id") as String

    fun OpenPage.isWithinScreen() = number("return document.documentElement.scrollWidth - innerWidth") <= 0

    browserTest("a log that arrives is announced once, and shown only on request") {
        onPage(page, laptop, state = "empty", script = watchedFolder(before)) {
            step("a log that arrives while another is shown is announced with its worst finding, and shown only on request") {
                openFolder()
                news() shouldBe ""
                openListed("practice")
                await("the log") { texts(".page-title h1").size == 1 }
                awaitState("ready")
                val shown = texts(".page-title h1")
                script(putIntoFolder(after))
                await("the news") { news() != "" }
                news() shouldStartWith "Qualification 42 arrived: "
                news() shouldContain "error"
                news() shouldContain "Low battery at 0:3"
                texts(".page-title h1") shouldBe shown
                seriousForReaders().shouldBeEmpty()
                isWithinScreen() shouldBe true
                keepScreenshot("arrival-1366-light")
                show(Screen.PHONE)
                isWithinScreen() shouldBe true
                keepScreenshot("phone-arrival")
                press("a")
                awaitLog("Qualification 42")
                await("its evidence") { elements(".evidence").any { it.isDisplayed } }
                news() shouldBe ""
                click("#go-back")
                await("the list") { listedLogs.size == 3 }
            }
            startOver("empty")
            show(laptop)
            step("an unreadable file removes no logs from the list; a new log is announced without hiding the page or moving the focus") {
                openFolder()
                script(
                    "window.folder = {get 'new.bag'() { window.looks = (window.looks ?? 0) + 1; return Promise.reject(new Error('locked')) }}",
                )
                await("two looks") { number("return window.looks ?? 0") >= 2 }
                listedLogs.size shouldBe 2
                script(putIntoFolder(after))
                await("the news") { news() != "" }
                click("#only-errors")
                await("the page to leave room for the news") {
                    number("return parseFloat(getComputedStyle(document.documentElement).scrollPaddingBottom)") ==
                        number("return document.querySelector('.arrival').offsetHeight")
                }
                focused() shouldBe "only-errors"
                // The announcement appears before the list's next row.
                await("the row of the new log") { listedLogs.any { "qualification-42.bag" in it } }
                elements("td.FINDINGS .is-error").size shouldBe listedLogs.size
                press("a")
                awaitLog("Qualification 42")
            }
        }
    }

    browserTest("the pit view shows the last match in large letters, the next step, batteries and earlier matches, and updates itself") {
        val matches = samples("practice.bag", "qualification-57.bag.gz")
        onPage(page, laptop, state = "empty", script = watchedFolder(matches)) {
            openFolder()
            press("i")
            texts(".pit-title").single() shouldContain "57"
            element(".log-table").isDisplayed shouldBe false
            script(putIntoFolder(samples("qualification-42.bag") + ("practice.bag" to matches.getValue("practice.bag"))))
            await("the next match") { texts(".pit-title").singleOrNull()?.contains("42") == true && "Browned out at" in texts(".is-large strong").single() }
            news() shouldBe ""
            (script("return document.querySelector('.pit [role=status]').textContent") as String) shouldStartWith "Qualification 42 arrived: 3 errors"
            texts(".is-large span").last() shouldStartWith "Next: "
            texts("div.big-card b").first() shouldStartWith "Battery: use "
            texts(".pit-before b").size shouldBe 1
            for (width in listOf(1366, 1920)) {
                show(Screen(width, if (width == 1366) 768 else 1080))
                number("return parseFloat(getComputedStyle(document.querySelector('.is-large strong')).fontSize)") shouldBeGreaterThan 55.0
                number("return parseFloat(getComputedStyle(document.querySelector('.is-large span')).fontSize)") shouldBeGreaterThan 27.0
                isWithinScreen() shouldBe true
                keepScreenshot("pit-$width")
            }
            show(laptop.copy(isDark = true))
            seriousForReaders().shouldBeEmpty()
            keepScreenshot("pit-1366-dark")
            show(Screen.PHONE)
            isWithinScreen() shouldBe true
            keepScreenshot("phone-pit")
            show(laptop)
            click(".is-large")
            awaitLog("Qualification 42")
            await("its evidence") { elements(".evidence").any { it.isDisplayed } }
            click("#go-back")
            await("the pit view") { elements(".pit").any { it.isDisplayed } }
            script("return document.activeElement.matches('.is-large')") shouldBe true
            press("i")
            element(".log-table").isDisplayed shouldBe true
        }
    }
})
