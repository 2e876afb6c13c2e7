package badlog.page

import badlog.core.bag.BagTopic
import io.kotest.core.annotation.Tags
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.ranges.shouldBeIn
import io.kotest.matchers.shouldBe

@Tags("InCheck")
internal class EventSpec : PageSpec({
    val topics = listOf(TIME, BagTopic("Angle", "deg"), BagTopic("Log", attributes = listOf("log")))
    val page by lazy {
        TestPages.of(
            bagOf(topics, 1001) { row, column ->
                when (column) {
                    0 -> row / 100.0
                    1 -> 0
                    else -> mapOf(150 to "autonomous", 800 to "brownout")[row]
                }
            },
        )
    }

    browserTest("events are listed, named by the cursor, and visited") {
        onPage(page) {
            step("events are listed with their times, in order, and the bar names the last one before the cursor") {
                texts(".event .event-go").map { it.toDouble() } shouldBe listOf(1.5, 8.0)
                texts(".event .finding-text") shouldBe listOf("autonomous", "brownout")
                graph("Angle").hover(0.9)
                texts(".event-readout").single() shouldBe "8.000  brownout"
                // Less than a mark's width before the second event, which has not happened yet.
                graph("Angle").hover(0.797)
                texts(".event-readout").single() shouldBe "1.500  autonomous"
            }
            step("a click on an event moves the cursor there, and the view if necessary; a button zooms to it") {
                graph("Angle").drag(0.0, 0.4)
                elements(".event")[1].click()
                settle()
                8.0 shouldBeIn visibleRange
                texts(".cursor-readout").single().substringBefore(' ').toDouble() shouldBe (8.0 plusOrMinus 0.001)
                act { moveToElement(elements(".event")[1]) }
                elements(".event .pin")[1].click()
                settle()
                8.0 shouldBeIn visibleRange
                visibleRange.endInclusive - visibleRange.start shouldBe (1.0 plusOrMinus 0.7)
            }
        }
    }
})
