package badlog.page

import badlog.core.bag.BagTopic
import badlog.protocol.PageAdditions
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import io.kotest.core.annotation.Tags
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import org.openqa.selenium.Keys

/** Paths on the field, and XY plots, of several logs on one page. */
@Tags("InCheck")
internal class ComparedPathSpec : PageSpec({
    val topics = listOf(TIME, BagTopic("Pose X", "m"), BagTopic("Pose Y", "m"), BagTopic("Pose Heading", "deg"), BagTopic("Current", "A"), BagTopic("Voltage", "V"))

    /** Returns a log that begins at [start]. Its robot drives along the field for 10 s, [y] from its side, on a battery of [ohms]. */
    fun log(start: Double, y: Double, ohms: Double = 0.01) = bagOf(topics, rows = 101) { row, column ->
        when (column) {
            0 -> start + row / 10.0
            1 -> 3 + row / 10.0
            2 -> y
            3 -> 0
            4 -> row
            else -> 12 - row * ohms
        }
    }

    val page by lazy { TestPages.of(log(0.0, 2.0), "own.bag", PageAdditions(rules = RuleSet.NONE.with(RuleSet.BUILT_IN.signals))) }

    fun OpenPage.awaitLogs(count: Int) = await("$count logs") { number("return document.querySelectorAll('#compare:not([hidden]) .compared-log').length") == count.toDouble() }

    /** Compares the page's log with [log], and waits until both paths are on the screen. */
    fun OpenPage.compareWith(log: ByteArray) {
        compare("other.bag" to log)
        awaitLogs(2)
        script("document.querySelector('#board .graph').scrollIntoView({block: 'center', behavior: 'instant'})")
        await("the path") { elements("#board .xy").size == 2 }
        settle()
    }

    fun OpenPage.legend() = texts("#board .graph[data-name='Path'] .legend-name")

    browserTest("paths and XY plots of compared logs are drawn over each other, move with their offsets, and are hidden together") {
        onPage(page, script = NOTING_TEXTS) {
            step("a compared log has its path on the same field, its robot and its values at the cursor, until it is removed") {
                for (screen in listOf(Screen.WIDE, Screen.WIDE.copy(isDark = true), Screen.PHONE)) {
                    show(screen)
                    val name = legend().single()
                    // The wall of the red alliance has nearly the same color.
                    val wall = pathPixels(1)
                    compareWith(log(100.0, 6.0))
                    legend() shouldContainExactly listOf(name, "$name (other.bag)")
                    pathPixels(1) shouldBeGreaterThan wall + 100
                    hoverPath(0.5, 0.68)
                    val (own, other) = pathValues()
                    own shouldContain ", 2.00 m · 0°"
                    // Both logs began at the same x, so the robots drive side by side.
                    other shouldBe own.replace(", 2.00 m", ", 6.00 m")
                    for (color in 0..1) pathPixels(color, layer = 1) shouldBeGreaterThan 60
                    keepScreenshot("compare-path-${screen.width}-${if (screen.isDark) "dark" else "light"}")
                    seriousForReaders() shouldBe emptyList()
                    element("#compare [aria-label='Stop comparing']").click()
                    settle()
                    legend() shouldContainExactly listOf(name)
                    pathPixels(1) shouldBe wall
                    pathPixels(1, layer = 1) shouldBe 0
                }
            }
            show(Screen.WIDE)
            step("a hidden line is hidden in all logs") {
                compareWith(log(100.0, 6.0))
                val drawn = pathPixels(1)
                elements("#board .graph[data-name='Path'] .legend-entry")[1].click()
                settle()
                elements("#board .graph[data-name='Path'] .legend-entry").map { it.getDomAttribute("aria-pressed") } shouldContainExactly listOf("false", "false")
                pathPixels(1) shouldBeLessThan drawn - 100
            }
            elements("#board .graph[data-name='Path'] .legend-entry")[1].click()
            element("#compare [aria-label='Stop comparing']").click()
            settle()
            step("a compared robot moves along with its log's offset") {
                compareWith(log(100.0, 6.0))
                hoverPath(0.5, 0.68)
                fun place(i: Int) = pathValues()[i].substringBefore(',').toDouble()
                val before = place(1)
                element(".compared-offset input").sendKeys(Keys.chord(Keys.CONTROL, "a"), "-98", Keys.ENTER)
                settle()
                pathValues()[0].substringBefore(',').toDouble() shouldBe before
                place(1) shouldBe before - 2
                // Then the cursor is before the beginning of that log.
                element(".compared-offset input").sendKeys(Keys.chord(Keys.CONTROL, "a"), "-80", Keys.ENTER)
                settle()
                pathValues()[1] shouldBe ""
            }
            startOver()
            step("an XY plot has the samples and the result of each log, and its figure names each") {
                script("location.hash = '#board=Current,Voltage,p='")
                reload()
                compareWith(log(100.0, 2.0, ohms = 0.03))
                val name = script("return document.querySelector('#board .graph').dataset.name") as String
                drawnTexts(name).map { it.text }.filter { "Resistance" in it } shouldContainExactly
                    listOf("Resistance 10.0 mΩ (own.bag)", "Resistance 30.0 mΩ (other.bag)")
                for (color in 0..1) pathPixels(color) shouldBeGreaterThan 100
                keepScreenshot("compare-xy")
                val figure = exported("Board as a drawing (SVG)", "own Board.svg").decodeToString()
                figure shouldContain "Voltage (other.bag)"
                figure shouldContain "Resistance 30.0 mΩ (other.bag)"
            }
        }
    }
})
