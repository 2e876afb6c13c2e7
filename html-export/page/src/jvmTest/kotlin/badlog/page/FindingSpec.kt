package badlog.page

import badlog.core.bag.BagTopic
import badlog.core.recording.Severity
import badlog.protocol.PageAdditions
import io.kotest.core.annotation.Tags
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import org.openqa.selenium.Keys

@Tags("InCheck")
internal class FindingSpec : PageSpec({
    val page by lazy {
        val topics = listOf(TIME, BagTopic("Angle", "deg"), BagTopic("Log", attributes = listOf("log")))
        val bag = bagOf(topics, 1001) { row, column ->
            when (column) {
                0 -> row / 100.0
                1 -> 0
                else -> "autonomous".takeIf { row == 150 }
            }
        }
        val findings = listOf(
            finding("Gap in time", Severity.NOTE, "no sample for 0.1 s", 2.0),
            finding("Over current", Severity.WARNING, "200 A for too long", 5.0, 6.5),
            finding("Brownout", Severity.ERROR, "the voltage fell", 8.0),
            finding("No vision", Severity.WARNING, "there was no target", Double.NaN),
        )
        TestPages.of(bag, additions = PageAdditions(findings = findings))
    }

    fun OpenPage.cursor() = texts(".cursor-readout").single().substringBefore(' ').toDouble()

    browserTest("findings are listed, searched, pointed at, and visited by keys") {
        onPage(page) {
            step("findings are listed with severity, time, rule and text, the worst first, and searched like events") {
                texts("#findings .unit").single() shouldBe "1 error, 2 warnings, 1 note"
                texts(".finding .severity") shouldBe listOf("error", "warning", "warning", "note")
                texts(".finding-source") shouldBe listOf("Brownout", "No vision", "Over current", "Gap in time")
                texts(".finding .event-go, .finding-whole") shouldBe listOf("8.000", "whole log", "5.000 – 6.500", "2.000")
                texts(".finding-text")[0] shouldContain "the voltage fell"
                press("/")
                press("brownout")
                texts(".finding-source") shouldBe listOf("Brownout")
                texts(".search-count").single() shouldBe "1 finding"
                press("xyz")
                texts(".finding-source") shouldBe emptyList()
                element("#findings").text shouldContain "hidden by the search"
            }
            press(Keys.ESCAPE)
            script("document.activeElement.blur()")
            step("the pointer on a mark, or in a band, shows the finding there, also in the bar") {
                graph("Angle").hover(0.8)
                graph("Angle").label shouldBe "error · Brownout: the voltage fell"
                texts(".event-readout").single() shouldContain "Brownout"
                graph("Angle").hover(0.6)
                graph("Angle").label shouldContain "200 A for too long"
                graph("Angle").hover(0.35)
                graph("Angle").label shouldBe ""
                texts(".event-readout").single() shouldContain "autonomous"
            }
            act { mouseTo(3, 3) }
            startOver()
            step("N goes to the next finding, Shift+N to the previous one, and both stop at the last one") {
                val times = listOf(1, 1, 1, 1, -1, -1, -1).map {
                    if (it > 0) press("n") else pressShift("n")
                    cursor()
                }
                times shouldBe listOf(2.0, 5.0, 8.0, 8.0, 5.0, 2.0, 2.0)
                // The whole range, to point between two findings.
                press("0")
                graph("Angle").hover(0.4)
                press("n")
                cursor() shouldBe 5.0
            }
        }
    }
})
