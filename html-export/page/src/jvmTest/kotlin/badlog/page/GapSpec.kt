package badlog.page

import badlog.core.bag.BagTopic
import io.kotest.core.annotation.Tags
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe

/** Where a robot logged nothing, a graph shows nothing. */
@Tags("InCheck")
internal class GapSpec : PageSpec({
    // A camera that sees its target in the first and the last tenth of 100 s, at 10 Hz.
    val page by lazy {
        val topics = listOf(TIME, BagTopic("Target", "deg"), BagTopic("Half", "deg"))
        TestPages.of(
            bagOf(topics, 1001) { row, column ->
                when {
                    column == 0 -> row / 10.0
                    column == 1 -> row.takeIf { it !in 100..900 }
                    else -> row.takeIf { it !in 400..600 }
                }
            },
        )
    }

    /** Returns the number of the frame's pixel columns with the line, between the shares [from] and [to] of its width. */
    fun OpenPage.drawnBetween(name: String, from: Double, to: Double): Int = graph(name).scrollTo().lineColumns().let { columns ->
        columns.subList((columns.size * from).toInt(), (columns.size * to).toInt()).count { it > 0 }
    }

    browserTest("a gap in a line is empty and has no value at the cursor, also in a line that is mostly gap") {
        onPage(page) {
            drawnBetween("Half", 0.1, 0.3) shouldBeGreaterThan 100
            drawnBetween("Half", 0.42, 0.58) shouldBe 0
            drawnBetween("Target", 0.01, 0.09) shouldBeGreaterThan 50
            drawnBetween("Target", 0.15, 0.85) shouldBe 0
            graph("Half").scrollTo().hover(0.5)
            graph("Half").value("Half") shouldBe "–"
            graph("Target").value("Target") shouldBe "–"
        }
    }
})
