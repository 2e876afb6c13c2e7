package badlog.page

import badlog.exporter.EmptyPage
import badlog.exporter.PageNetwork
import badlog.formats.driverstation.TestDslog
import badlog.web.LogServerOptions
import io.kotest.core.annotation.Tags
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.doubles.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import org.openqa.selenium.Keys
import java.io.InputStream
import java.net.URI
import java.util.function.BooleanSupplier
import kotlin.io.path.appendBytes
import kotlin.io.path.appendText
import kotlin.io.path.div
import kotlin.io.path.writeBytes
import kotlin.io.path.writeText

/** A log that is followed while a robot writes it. */
@Tags("InCheck")
internal class LiveSpec : RunningLogSpec({
    /** Waits until all rows of [robot] are shown. */
    fun OpenPage.awaitRows(robot: WritingRobot) {
        await("all rows") { visibleRange.endInclusive > robot.rows / 50.0 - 0.1 }
        awaitReady()
    }

    browserTest("a growing log is followed at its newest moment until the reader goes elsewhere in it; Live follows it again") {
        onRunningLog("follow", screen = Screen.PHONE) { robot ->
            visibleRange.endInclusive shouldBe (9.98 plusOrMinus 0.02)
            element("#live").click()
            robot.write(250)
            await("15 s") { visibleRange.endInclusive > 14.9 }
            awaitReady()
            graph("Count").value("Count") shouldBe "749"
            keepScreenshot("live-phone")
            isLive() shouldBe true
            // A touch, the pointer over a graph, and the open list of values do not go elsewhere in the log.
            for (type in listOf("pointerdown", "pointerup")) script("document.querySelector('.page-title').dispatchEvent(new PointerEvent('$type', {bubbles: true}))")
            graph("Count").scrollTo().hover(0.5)
            script("scrollTo(0, 0)")
            settle()
            element("#values-button").click()
            robot.write(50)
            await("16 s") { visibleRange.endInclusive > 15.9 }
            awaitReady()
            isLive() shouldBe true
            element("#cursor-values").isDisplayed shouldBe true
            element("#values-button").click()
            press(Keys.ARROW_LEFT)
            isLive() shouldBe false
            robot.write(250)
            settle()
            visibleRange.endInclusive shouldBe (15.98 plusOrMinus 0.02)
            graph("Count").scrollTo()
            press("+")
            element("#live").click()
            await("21 s") { visibleRange.endInclusive > 20.9 }
            awaitReady()
            // The zoom is the same as before.
            visibleRange.start shouldBeGreaterThan 5.0
        }
    }

    browserTest("a reader who follows a log before its rules have run is not taken to the worst finding") {
        val robot = WritingRobot(logs("worst") / "running.bag").apply { write(500) }
        robot.volts = 6.1
        robot.write(100)
        onLogIn(robot.file.parent) {
            element("#go-back").click()
            val worst = "td.FINDINGS button"
            await("the worst in the list") { elements(worst).isNotEmpty() }
            script(
                "new MutationObserver((_, observer) => { const live = document.querySelector('#live'); if (live) { observer.disconnect(); live.click() } })" +
                    ".observe(document.body, {childList: true, subtree: true})",
            )
            element(worst).click()
            await("the log") { elements("#live").isNotEmpty() }
            awaitReady()
            await("the finding") { (texts(".findings-list") + texts(".incidents")).any { "Low battery" in it } }
            isLive() shouldBe true
            robot.write(50)
            await("13 s") { visibleRange.endInclusive > 12.9 }
            isLive() shouldBe true
        }
    }

    browserTest("a reader of a growing log is not interrupted by buttons, keys, gaps and findings") {
        onFollowedLog("reader") { robot ->
            step("another mouse button, or a press that ends outside the window, does not delay new rows") {
                fun pressed(button: Int) = script("document.querySelector('.page-title').dispatchEvent(new PointerEvent('pointerdown', {bubbles: true, button: $button}))")
                pressed(button = 2)
                robot.write(50)
                awaitRows(robot)
                for (end in listOf("document.querySelector('.page-title').dispatchEvent(new MouseEvent('contextmenu', {bubbles: true}))", "window.dispatchEvent(new Event('blur'))")) {
                    pressed(button = 0)
                    script(end)
                    robot.write(50)
                    awaitRows(robot)
                }
                isLive() shouldBe true
            }
            step("following survives a gap of a second in the Wi-Fi") {
                val lost = "Promise.reject(new TypeError('Failed to fetch'))"
                script("const real = fetch; let left = 3; window.fetch = (...asked) => left-- > 0 ? $lost : real(...asked)")
                robot.write(250)
                awaitRows(robot)
                isLive() shouldBe true
            }
            step("a slow click on Live stops it while the log grows") {
                val (x, y) = element("#live").rect.let { it.x + it.width / 2 to it.y + it.height / 2 }
                script("const set = setTimeout; window.looks = 0; window.setTimeout = (work, delay, ...more) => { if (delay === 10) looks++; return set(work, delay, ...more) }")
                act { mouseTo(x, y).mouseDown() }
                robot.write(250)
                await("what is new to be held up") { number("return looks") > 3 }
                settle()
                act { mouseUp() }
                isLive() shouldBe false
            }
            step("a growing log does not interrupt a reader who begins a formula or opens the help") {
                // Rows written meanwhile recreate the page, with other buttons.
                fun follow() {
                    element("#live").click()
                    awaitRows(robot)
                }
                for (begin in listOf("#add-formula", "#help-button")) {
                    follow()
                    isLive() shouldBe true
                    element(begin).click()
                    isLive() shouldBe false
                    robot.write(50)
                    settle()
                    elements("dialog[open]").size shouldBe 1
                    press(Keys.ESCAPE)
                    settle()
                }
                follow()
                press("f")
                robot.write(50)
                await("a pause") { !isLive() }
                elements("dialog[open]").size shouldBe 1
            }
            press(Keys.ESCAPE)
            step("findings in a followed log appear as they happen, and the board stays") {
                (texts(".findings-list") + texts(".incidents")).any { "Low battery" in it } shouldBe false
                script("arguments[0].querySelector('.pin').click()", graph("Battery Voltage").card)
                settle()
                texts("#board .graph-title") shouldBe listOf("Battery Voltage")
                element("#live").click()
                robot.volts = 6.1
                robot.write(100)
                await("the finding") { texts(".findings-list").any { "Low battery" in it } || texts(".incidents").any { "Low battery" in it } }
                // It stays while the page follows.
                repeat(2) {
                    robot.write(20)
                    settle()
                    (texts(".findings-list") + texts(".incidents")).joinToString() shouldContain "Low battery"
                    texts("#board .graph-title") shouldBe listOf("Battery Voltage")
                }
                (visibleRange.endInclusive > 10.0) shouldBe true
            }
        }
    }

    browserTest("a log is followed wherever its parts end: a row is shown once it is complete, so that 12.4 is never read as 1") {
        // In a table with the row number as x axis, the last row needs no line end.
        val file = logs("parts") / "running.csv"
        file.writeText("Time,Volts\n" + (0..499).joinToString("") { "${it / 50.0},12\n" })
        val binary = file.resolveSibling("binary.dslog")
        val bytes = TestDslog().records(750).bytes
        val written = TestDslog().records(500).bytes.size
        binary.writeBytes(bytes.copyOf(written))
        onLogIn(file.parent) {
            element("#live").click()
            for (part in listOf("10,", "12", ".4")) {
                clearAsked()
                file.appendText(part)
                awaitFetched(more = 2)
                visibleRange.endInclusive shouldBe 499.0
            }
            file.appendText("\n")
            await("the row") { visibleRange.endInclusive == 500.0 }
            awaitReady()
            graph("Volts").value("Volts") shouldBe "12.4"
            isLive() shouldBe true
            click("#go-back")
            openRunning("binary")
            val end = visibleRange.endInclusive
            element("#live").click()
            binary.appendBytes(bytes.copyOfRange(written, bytes.size))
            await("5 s more") { visibleRange.endInclusive > end + 4.9 }
            isLive() shouldBe true
        }
    }

    browserTest("Live reports when it is too far behind an enabled robot, and ends on the field with the reason on the button") {
        val options = LogServerOptions()
        onRunningLog("behind", options, says = listOf("ERR_"), motors = 46) { robot ->
            step("Live reports when it is too far behind an enabled robot, and continues at the newest moment once the robot is disabled") {
                options.isEnabled = BooleanSupplier { true }
                robot.write(5000)
                element("#live").click()
                await("the reason") { "Live is more than a megabyte behind" in texts("#live").single() }
                isLive() shouldBe false
                options.isEnabled = BooleanSupplier { false }
                element("#live").click()
                // The earlier problem is no longer shown.
                texts("#live") shouldBe listOf("Live")
                await("110 s") { visibleRange.endInclusive > 109.9 }
                isLive() shouldBe true
            }
            step("following continues while the robot is enabled, and ends on the field with the reason on the button") {
                // The log of an enabled robot is sent if it was written in the last ten seconds.
                robot.write(1)
                options.isEnabled = BooleanSupplier { true }
                robot.write(249)
                awaitRows(robot)
                options.isFieldAttached = BooleanSupplier { true }
                await("the reason") { "connected to the field" in texts("#live").single() }
                isLive() shouldBe false
            }
        }
    }

    browserTest("a log is followed although its server only sends whole logs, which are requested as rarely as their size demands") {
        val robot = WritingRobot(logs("whole") / "running.bag").apply { write(500) }
        EmptyPage().write(robot.file.parent / EmptyPage.SERVED_NAME, PageNetwork.ROBOT)
        WpilibServer(robot.file.parent).use { server ->
            onServedPage(server.addressOf(EmptyPage.SERVED_NAME)) {
                script("keepsTime = true")
                openRunning()
                element("#live").click()
                robot.write(250)
                await("15 s") { visibleRange.endInclusive > 14.9 }
                awaitReady()
                element("#live").click()
                isLive() shouldBe false
            }
        }
    }

    browserTest("following waits some seconds for a place while others download") {
        val robot = WritingRobot(logs("busy") / "running.bag").apply { write(500) }
        (robot.file.parent / "long.bag").writeBytes(ByteArray(20_000_000))
        withRobot(robot.file.parent) { address ->
            onServedPage(address, says = listOf("status of 503")) {
                script("keepsTime = true; performance.setResourceTimingBufferSize(1e5)")
                openRunning()
                element("#live").click()
                val others = ArrayList<InputStream>()
                // The page's own requests need places, too.
                await("two downloads") {
                    runCatching { others += URI("${address}logs/long.bag").toURL().openStream().apply { read() } }
                    others.size == 2
                }
                robot.write(250)
                await("a refusal") { script("return performance.getEntriesByType('resource').some(e => e.responseStatus === 503)") as Boolean }
                isLive() shouldBe true
                others.forEach { it.close() }
                await("15 s") { visibleRange.endInclusive > 14.9 }
                isLive() shouldBe true
            }
        }
    }
})
