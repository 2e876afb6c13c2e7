package badlog.page

import badlog.core.bag.BagTopic
import badlog.exporter.EmptyPage
import badlog.exporter.HtmlExporter
import badlog.exporter.NotesFile
import badlog.files.gzip
import badlog.formats.driverstation.STATION_EVENTS
import badlog.formats.driverstation.STATION_LOG
import badlog.viewer.choices.note.Note
import io.kotest.assertions.withClue
import io.kotest.core.annotation.Tags
import io.kotest.inspectors.forNone
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.longs.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import org.openqa.selenium.Keys
import java.nio.file.Files
import kotlin.io.path.div
import kotlin.io.path.readBytes
import kotlin.io.path.readText
import kotlin.io.path.writeBytes

/** The page without a log, which opens others. */
@Tags("InCheck")
internal class EmptyPageSpec : PageSpec({
    val folder by lazy { Files.createTempDirectory("badlog-empty") }
    val page by lazy { (folder / EmptyPage.NAME).also { EmptyPage().write(it) } }

    afterSpec { folder.toFile().deleteRecursively() }

    fun OpenPage.awaitLog(title: String) {
        await("the log $title") { texts(".page-title h1") == listOf(title) }
        awaitState("ready")
    }

    /** Opens the page, and waits until it accepts files. */
    fun onEmptyPage(test: OpenPage.() -> Unit) = onPage(page, state = "empty", test = test)

    val bag = bagOf(listOf(TIME, BagTopic("Volts", "V")), rows = 11) { row, column -> if (column == 0) row / 10.0 else 12.0 }

    test("the page without a log is at most 600,000 bytes, besides its sample") {
        val sample = page.readText().substringAfter("id=\"sample\"", "").substringBefore("</script>")
        sample.length shouldBeGreaterThan 10_000
        Files.size(page) - sample.length shouldBeLessThanOrEqual 600_000L
    }

    test("the page without a log may load nothing from any network") {
        page.readText() shouldContain "default-src 'none'"
        page.readText().contains("connect-src") shouldBe false
    }

    browserTest("the page names the logs that it opens, opens its sample and dropped logs, and refuses other files") {
        val dark = Screen.WIDE.copy(isDark = true)
        onEmptyPage {
            step("the page names the logs that it opens, and opens its sample with findings") {
                for (screen in listOf(Screen.PHONE, dark)) {
                    show(screen)
                    text shouldContain "Open a robot’s log"
                    seriousForReaders() shouldBe emptyList()
                    (number("return document.documentElement.scrollWidth - innerWidth") <= 0) shouldBe true
                    keepScreenshot("empty-${screen.width}-${if (screen.isDark) "dark" else "light"}")
                }
                click("#try-sample")
                await("the sample") { texts(".page-title h1").isNotEmpty() }
                awaitState("ready")
                text shouldContain "Likely cause: the robot drew more than its battery gives."
                texts(".finding-text").forNone { it shouldContain "restarted" }
            }
            click("#go-back")
            awaitState("empty")
            step("a dropped log is opened, its bytes can be saved, and after the back button another one can be opened") {
                drop("first.bag" to bag)
                awaitLog("first.bag")
                number("return document.querySelectorAll('.graph[data-name=\"Volts\"]').length") shouldBe 1.0
                withClue("the very bytes") { saved("first.bag") { click("#download") } shouldBe bag }
                click("#go-back")
                awaitState("empty")
                drop("second.csv" to "Time,Amps\n0,1\n1,2\n".encodeToByteArray())
                awaitLog("second.csv")
                texts(".graph-title") shouldContain "Amps"
                press("?")
                texts("#help[open]").size shouldBe 1
            }
            press(Keys.ESCAPE)
            click("#go-back")
            awaitState("empty")
            step("an unsupported kind of log is refused with the next step, and a file that is not a log with a sentence") {
                for ((name, advice) in listOf("a.wpilogxz" to "7-Zip", "c.hoot" to "badlog convert")) {
                    drop(name to byteArrayOf(1, 2, 3))
                    awaitState("failed")
                    text shouldContain "This page cannot read $name"
                    text shouldContain advice
                    click("#go-back")
                    awaitState("empty")
                }
                drop("pit.jpg" to byteArrayOf(-1, -40, -1, 0, 0, 16))
                awaitState("failed")
                text shouldContain "There is nothing to show in pit.jpg"
            }
        }
    }

    browserTest("a copy of the page has the opened log, byte for byte, with the board and the notes") {
        val cases = listOf("packed.bag.gz" to gzip(bag), "cut.bag.gz" to gzip(bag).let { it.copyOf(it.size * 2 / 3) })
        val (log, events) = listOf("2026_03_14 10_00_00 Sat.dslog", "2026_03_14 10_00_00 Sat.dsevents")
        val station = mapOf(log to STATION_LOG.bytes, events to STATION_EVENTS.bytes)

        fun OpenPage.saveCopy(name: String) {
            val copy = exported("A copy of this page, with your notes and board", name.substringBeforeLast('.') + ".html")
            (folder / "$name.html").writeBytes(copy)
            click("#go-back")
            awaitState("empty")
        }
        onEmptyPage {
            for ((name, bytes) in cases) {
                drop(name to bytes)
                awaitLog(name)
                saveCopy(name)
            }
            step("both files of a Driver Station log are opened as one log") {
                drop(*station.toList().reversed().toTypedArray())
                await("the log") { texts(".page-title h1").size == 1 }
                awaitState("ready")
                saveCopy(log)
            }
        }
        for ((name, bytes) in cases) {
            onPage(folder / "$name.html") {
                texts(".page-title h1") shouldContainExactly listOf(name)
                saved(name) { click("#download") } shouldBe bytes
                if (name.startsWith("cut")) text shouldContain "cut off or damaged"
                (elements("#go-back").isEmpty()) shouldBe true
            }
        }
        step("a copy of the page has both files of a Driver Station log") {
            onPage(folder / "$log.html") {
                saved(log) { click("#download") } shouldBe station.getValue(log)
                saved(events) { click("#download-second") } shouldBe station.getValue(events)
            }
        }
    }

    browserTest("the log in another page is opened, nothing of a damaged or foreign page is shown, and a page with a log compares a dropped one") {
        step("on a page with a log, a dropped log is compared, or opened instead") {
            onPage(TestPages.of(bag, "own.bag")) {
                drop("other.bag" to bag)
                choose("Open instead")
                awaitLog("other.bag")
                drop("own.bag" to bag)
                choose("Compare with this log")
                await("two logs") { texts(".compared-log .cut-name") == listOf("other.bag", "own.bag") }
                // This loads the page again, so there is nothing to settle.
                element("#go-back").click()
                awaitLog("own.bag")
            }
        }
        step("the log in another page is opened whatever its name, and nothing of a damaged or foreign page is shown") {
            val name = "Mödül 1.bag"
            val log = folder.resolve(name).also { it.writeBytes(bag) }
            NotesFile.update(log, listOf(Note(1.0, "hit by 254")), read = emptyList())
            val whole = (folder / "whole.html").also { HtmlExporter().export(log, it) }.readBytes()
            val at = whole.decodeToString(throwOnInvalidSequence = false).let { text -> text.indexOf("id=\"recording\"") + 200 }
            val damaged = whole.copyOf().also { it[at] = if (it[at] == 'A'.code.toByte()) 'B'.code.toByte() else 'A'.code.toByte() }
            onEmptyPage {
                drop("page.html" to whole)
                awaitLog(name)
                saved(name) { click("#download") } shouldBe bag
                texts("#notes .finding-text") shouldBe listOf("hit by 254")
                for ((what, bytes, sentence) in listOf(
                    Triple("damaged.html", damaged, "damaged in copying"),
                    Triple("foreign.html", "<!DOCTYPE html><p>Hello".encodeToByteArray(), "not a badlog page"),
                    Triple("cut.html", whole.copyOf(at + 100), "damaged in copying"),
                )) {
                    click("#go-back")
                    awaitState("empty")
                    drop(what to bytes)
                    awaitState("failed")
                    text shouldContain sentence
                }
            }
        }
    }

    browserTest("a copy of the page has the compared logs as they are shown, dropped or not, but none that was removed") {
        val own = TestPages.ofSamples("wrong-turn.bag", listOf("practice.bag", "elevator-bench.csv"))
        val file = folder / "compared.html"

        fun OpenPage.compared() = texts(".compared-log .cut-name").drop(1)

        fun OpenPage.saveCopy() = file.writeBytes(exported("A copy of this page, with your notes and board", "wrong-turn.html"))
        onPage(own) {
            await("the page's own logs") { compared() == listOf("practice.bag", "elevator-bench.csv") }
            compare("practice.bag" to bag, "third.bag.gz" to gzip(bag))
            await("four logs, one for each name") { compared() == listOf("elevator-bench.csv", "practice.bag", "third.bag.gz") }
            saveCopy()
        }
        onPage(file) {
            await("the same four logs") { compared() == listOf("elevator-bench.csv", "practice.bag", "third.bag.gz") }
            texts("script.compared").map { it.length < 1000 } shouldContainExactly listOf(false, true, true)
            elements(".compared-log .icon-button")[0].click()
            await("three logs") { compared().size == 2 }
            saveCopy()
        }
        onPage(file) { await("the same three logs") { compared() == listOf("practice.bag", "third.bag.gz") } }
    }
})
