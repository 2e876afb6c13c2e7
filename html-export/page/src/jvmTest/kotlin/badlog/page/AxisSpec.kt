package badlog.page

import badlog.core.bag.BagTopic
import io.kotest.core.annotation.Tags
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe

@Tags("InCheck")
internal class AxisSpec : PageSpec({
    /** Runs [action] and waits until the page shows its log again. */
    fun OpenPage.showAgain(action: () -> Unit) {
        script("document.querySelector('.log-page').isOld = true")
        action()
        await("the log to be shown again") { script("return document.querySelector('.log-page')?.isOld ?? null") == null }
        awaitState("ready")
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

    // Both run from 100 to 110 V.
    val shapes by lazy {
        val topics = listOf(
            TIME,
            BagTopic("Plain", "V"),
            BagTopic("Zero", "V", listOf("zero")),
            BagTopic("Area", "V", listOf("area", "zero")),
        )
        TestPages.of(bagOf(topics, 101) { row, column -> if (column == 0) row else 100 + row / 10.0 })
    }

    /** Returns the highest and lowest position of the line, as shares of the frame from its top. */
    fun OpenPage.heights(name: String): Pair<Double, Double> {
        val rows = graph(name).picture.rowsOf(color("--line-0"))
        val drawn = rows.indices.filter { rows[it] > 0 }
        return drawn.first().toDouble() / rows.size to drawn.last().toDouble() / rows.size
    }

    browserTest("zero only adds 0 to the y axis, and area fills the space below the line") {
        onPage(shapes) {
            val (plainTop, plainBottom) = heights("Plain")
            plainTop shouldBe (0.06 plusOrMinus 0.06)
            plainBottom shouldBe (0.94 plusOrMinus 0.06)
            val (zeroTop, zeroBottom) = heights("Zero")
            zeroTop shouldBe (0.06 plusOrMinus 0.04)
            // 100 of 110 V.
            (1 - zeroBottom) / (1 - zeroTop) shouldBe (100.0 / 110 plusOrMinus 0.03)
            graph("Area").picture.opacityAt(0.53, 0.53) shouldBeGreaterThan graph("Zero").picture.opacityAt(0.53, 0.53)
            graph("Zero").picture.opacityAt(0.53, 0.53) shouldBe 0
        }
    }
})
