package badlog.page

import badlog.core.bag.BagTopic
import badlog.protocol.PageAdditions
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import io.kotest.core.annotation.Tags
import io.kotest.matchers.collections.shouldContainExactly
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain

/** The paths of several logs on one page. */
@Tags("InCheck")
internal class ComparedPathSpec : PageSpec({
    val topics = listOf(TIME, BagTopic("Pose X", "m"), BagTopic("Pose Y", "m"), BagTopic("Pose Heading", "deg"))

    /** Returns a log that begins at [start]. Its robot drives along the field for 10 s, [y] from its side. */
    fun log(start: Double, y: Double) = bagOf(topics, rows = 101) { row, column ->
        when (column) {
            0 -> start + row / 10.0
            1 -> 3 + row / 10.0
            2 -> y
            else -> 0
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

    browserTest("a compared log has its path on the same field, its robot and its values at the cursor, until it is removed") {
        onPage(page) {
            for (screen in listOf(Screen.WIDE, Screen.PHONE.copy(isDark = true))) {
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
    }
})
