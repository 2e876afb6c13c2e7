package badlog.page

import io.kotest.assertions.withClue
import io.kotest.core.annotation.Tags
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import java.util.Locale

@Tags("InCheck")
internal class AxisSpec : PageSpec({
    fun OpenPage.numbers(name: String) = drawnTexts(name).filter { it.text.toDoubleOrNull() != null }.distinct()

    /** Returns the numbers beside the frame of the graph [name], from top to bottom. */
    fun OpenPage.yTicks(name: String): List<DrawnText> {
        val edge = frameLeft(name)
        return numbers(name).filter { it.right <= edge }.sortedBy { it.y }
    }

    /** Returns the numbers below the frame, from left to right. */
    fun OpenPage.xTicks(name: String): List<DrawnText> {
        val edge = frameLeft(name)
        return numbers(name).filter { it.right > edge }.sortedBy { it.left }
    }

    /** Runs [action] and waits until the page shows its log again. */
    fun OpenPage.showAgain(action: () -> Unit) {
        script("document.querySelector('.log-page').isOld = true")
        action()
        await("the log to be shown again") { script("return document.querySelector('.log-page')?.isOld ?? null") == null }
        awaitState("ready")
    }

    browserTest("the numbers of y have equal distances, and those of a clock that counts from 1970 differ from one another") {
        val rows = (0..500).joinToString("") { "%.3f,%.6f%n".format(Locale.ROOT, 1_710_585_667.0 + it * 0.02, it * 0.000_004) }
        val header = """{"topics":[{"name":"Time","unit":"s","attrs":["xaxis"]},{"name":"A"}],"values":[]}"""
        onPage(TestPages.of("$header\nTime,A\n$rows"), script = NOTING_TEXTS) {
            val ticks = yTicks("A")
            withClue(ticks.map { it.text }) {
                ticks.size shouldBeGreaterThan 2
                val steps = ticks.zipWithNext { upper, lower -> upper.text.toDouble() - lower.text.toDouble() }
                for (step in steps) step shouldBe (steps.average() plusOrMinus steps.average() * 1e-6)
            }
            val times = xTicks("A").map { it.text }
            withClue(times) {
                times.size shouldBeGreaterThan 1
                times.toSet().size shouldBe times.size
            }
        }
    }

    browserTest("a table without an x axis offers its time column once, and remembers the choice") {
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
})
