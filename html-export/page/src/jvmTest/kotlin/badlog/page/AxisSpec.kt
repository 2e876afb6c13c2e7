package badlog.page

import badlog.core.bag.BagTopic
import io.kotest.assertions.withClue
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import java.util.Locale

internal class AxisSpec : PageSpec({
    fun OpenPage.numbers(name: String) = drawnTexts(name).filter { it.text.toDoubleOrNull() != null }.distinct()

    /** The numbers beside the frame of the graph [name], from top to bottom. */
    fun OpenPage.yTicks(name: String): List<DrawnText> {
        val edge = frameLeft(name)
        return numbers(name).filter { it.right <= edge }.sortedBy { it.y }
    }

    /** The numbers below the frame, from left to right. */
    fun OpenPage.xTicks(name: String): List<DrawnText> {
        val edge = frameLeft(name)
        return numbers(name).filter { it.right > edge }.sortedBy { it.left }
    }

    /** Does [action], after which the page shows its log again, and waits for that. */
    fun OpenPage.showAgain(action: () -> Unit) {
        script("document.querySelector('.log-page').isOld = true")
        action()
        await("the log to be shown again") { script("return document.querySelector('.log-page')?.isOld ?? null") == null }
        awaitState("ready")
    }

    for ((least, most) in listOf(0.0 to 1.0, -3.0 to 7.0, 0.0 to 12.7, -1.0 to 1.0, 0.0 to 0.002, 99.0 to 99.5)) {
        browserTest("the ticks of $least to $most are written exactly: as evenly as they stand") {
            val bag = bagOf(listOf(TIME, BagTopic("A")), 101) { row, column ->
                if (column == 0) row / 10.0 else least + (most - least) * row / 100
            }
            onPage(TestPages.of(bag), script = NOTING_TEXTS) {
                val ticks = yTicks("A")
                withClue(ticks.map { it.text }) {
                    ticks.size shouldBeGreaterThan 2
                    val steps = ticks.zipWithNext { upper, lower -> upper.text.toDouble() - lower.text.toDouble() }
                    for (step in steps) step shouldBe (steps.average() plusOrMinus steps.average() * 1e-6)
                }
            }
        }
    }

    browserTest("ticks of a clock that counts from 1970 or in microseconds differ from one another") {
        for ((start, step) in listOf(1_710_585_667.0 to 0.02, 150_000_000.0 to 20_000.0)) {
            val rows = (0..500).joinToString("") { "%.3f,%d%n".format(Locale.ROOT, start + it * step, it % 7) }
            val header = """{"topics":[{"name":"Time","unit":"s","attrs":["xaxis"]},{"name":"A"}],"values":[]}"""
            onPage(TestPages.of("$header\nTime,A\n$rows"), script = NOTING_TEXTS) {
                val ticks = xTicks("A").map { it.text }
                withClue(ticks) { ticks.toSet().size shouldBe ticks.size }
            }
        }
    }

    browserTest("a table that names no x axis offers its column of the time, once, and remembers what was chosen") {
        val csv = "A,timestamp\n" + (0..500).joinToString("") { "${it % 7},${100 + it / 10.0}\n" }
        onPage(TestPages.of(csv, "table.csv")) {
            visibleRange shouldBe 0.0..500.0
            showAgain { click("#axis-time") }
            visibleRange shouldBe 100.0..150.0
            reload()
            visibleRange shouldBe 100.0..150.0
            elements("#axis-time").size shouldBe 0
            showAgain { click("#axis-rows") }
            visibleRange shouldBe 0.0..500.0
            reload()
            elements("#axis-choice").size shouldBe 0
        }
    }

    browserTest("one wild x leaves the others to be seen, and is reported with its number") {
        val bag = bagOf(listOf(TIME, BagTopic("A")), 1001) { row, column ->
            if (column == 1) {
                row % 7
            } else if (row == 400) {
                18_447_000_000_000.0
            } else {
                row / 100.0
            }
        }
        onPage(TestPages.of(bag)) {
            visibleRange shouldBe 0.0..10.0
            click(".problems-toggle")
            text shouldContain "far off in 1 of 1001 rows, such as at 18447000000000"
        }
    }
})
