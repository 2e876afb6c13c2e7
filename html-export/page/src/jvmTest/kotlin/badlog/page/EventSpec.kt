package badlog.page

import badlog.core.bag.BagTopic
import io.kotest.core.annotation.Tags
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.ints.shouldBeGreaterThan
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

    /** Returns the number of pixels with the color of events, around a place of the graph. */
    fun OpenPage.eventPixels(across: Double): Int {
        val columns = graph("Angle").picture.columnsOf(color("--event"))
        val middle = (columns.size * across).toInt()
        return columns.subList(middle - 6, middle + 6).sum()
    }

    browserTest("events are listed, marked on graphs, and visited") {
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
            step("each event is marked on the graph at its time, and there are no other marks") {
                eventPixels(0.15) shouldBeGreaterThan 5
                eventPixels(0.8) shouldBeGreaterThan 5
                eventPixels(0.5) shouldBe 0
                graph("Angle").drag(0.7, 0.9)
                eventPixels(0.5) shouldBeGreaterThan 5
                eventPixels(0.15) shouldBe 0
            }
            click("#reset")
            step("a click on an event moves the cursor there, and the view if necessary; a button zooms to it") {
                graph("Angle").drag(0.0, 0.4)
                elements(".event")[1].click()
                settle()
                8.0 shouldBeIn visibleRange
                texts(".cursor-readout").single().substringBefore(' ').toDouble() shouldBe (8.0 plusOrMinus 0.001)
                elements(".event")[0].click()
                settle()
                1.5 shouldBeIn visibleRange
                click("#back")
                8.0 shouldBeIn visibleRange
                act { moveToElement(elements(".event")[1]) }
                elements(".event .pin")[1].click()
                settle()
                8.0 shouldBeIn visibleRange
                visibleRange.endInclusive - visibleRange.start shouldBe (1.0 plusOrMinus 0.7)
            }
        }
    }

    browserTest("the link to the event log is at the top, and an empty one says so") {
        step("the link to the event log is at the top, and has the number of events") {
            onPage(TestPages.ofSample("qualification-42.bag")) {
                texts(".events-link .count").single().toInt() shouldBe elements(".event").size
                click("#collapse-all")
                click(".events-link")
                number("return document.querySelector('.events').getBoundingClientRect().top") shouldBeLessThan 300.0
                press("/")
                press("brownout")
                texts(".events-link .count").single().toInt() shouldBe elements(".event").size
            }
        }
        step("an empty event log says so, instead of showing an empty list") {
            onPage(TestPages.of(bagOf(topics, 101) { row, column -> if (column == 2) null else row / 10.0 })) {
                texts(".events p") shouldBe listOf("No events.")
                elements(".events ol").count { it.isDisplayed } shouldBe 0
            }
        }
    }
})
