package badlog.page

import badlog.core.analysis.Span
import badlog.core.bag.BagTopic
import badlog.core.recording.Severity
import badlog.protocol.PageAdditions
import badlog.rules.Finding
import io.kotest.core.annotation.Tags
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.doubles.shouldBeGreaterThan
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.ints.shouldBeLessThan
import io.kotest.matchers.ranges.shouldBeIn
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import org.openqa.selenium.Keys
import java.nio.file.Path

private const val NEVER = Double.NaN

@Tags("InCheck")
internal class FindingSpec : PageSpec({
    fun pageWith(findings: List<Finding>): Path {
        val topics = listOf(TIME, BagTopic("Angle", "deg"), BagTopic("Log", attributes = listOf("log")))
        val bag = bagOf(topics, 1001) { row, column ->
            when (column) {
                0 -> row / 100.0
                1 -> 0
                else -> "autonomous".takeIf { row == 150 }
            }
        }
        return TestPages.of(bag, additions = PageAdditions(findings = findings))
    }

    val page by lazy {
        pageWith(
            listOf(
                finding("Gap in time", Severity.NOTE, "no sample for 0.1 s", 2.0, NEVER),
                finding("Over current", Severity.WARNING, "200 A for too long", 5.0, 6.5),
                finding("Brownout", Severity.ERROR, "the voltage fell", 8.0, NEVER),
                finding("No vision", Severity.WARNING, "there was no target", NEVER, NEVER),
            ),
        )
    }

    fun OpenPage.cursor() = texts(".cursor-readout").single().substringBefore(' ').toDouble()

    browserTest("findings are listed, marked, searched, pointed at, and visited by clicks and keys") {
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
            step("each finding is marked at the foot of a graph, away from the events, light and dark") {
                for (isDark in listOf(true, false)) {
                    show(Screen.WIDE.copy(isDark = isDark))
                    val picture = graph("Angle").picture
                    fun pixels(shade: String, across: Double): Int {
                        val middle = (picture.width * across).toInt()
                        return picture.columnsOf(color(shade)).subList(middle - 6, middle + 6).sum()
                    }
                    pixels("--error", 0.8) shouldBeGreaterThan 20
                    pixels("--warning", 0.5) shouldBeGreaterThan 20
                    pixels("--error", 0.3) shouldBe 0
                    val rows = picture.rowsOf(color("--error"))
                    rows.drop(10).dropLast(20).max() shouldBeLessThan 3
                    rows.takeLast(12).max() shouldBeGreaterThan 6
                    val foot = picture.rowsOf(color("--warning")).takeLast(4).max()
                    foot shouldBeGreaterThan (picture.width * 0.14).toInt()
                }
            }
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
            press("0")
            step("a click on a finding moves cursor and view to its time, and the view includes its end") {
                graph("Angle").drag(0.0, 0.4)
                elements(".finding .event-go")[0].click()
                settle()
                cursor() shouldBe (8.0 plusOrMinus 0.001)
                8.0 shouldBeIn visibleRange
                element(".finding[aria-current]").text shouldContain "Brownout"
                elements(".finding .event-go")[2].click()
                settle()
                visibleRange.start shouldBeLessThan 5.0
                visibleRange.endInclusive shouldBeGreaterThan 6.5
                visibleRange.endInclusive - visibleRange.start shouldBeLessThan 3.0
            }
        }
    }

    browserTest("N goes through the places of a finding, does nothing without findings, and stays within the recording") {
        step("a finding with several places is listed once, marked at each place, and N goes through the places") {
            val further = listOf(Span(4.0, 4.5), Span(9.0, 9.0))
            val twin = finding("Twin", Severity.NOTE, "at the same time", 9.0, NEVER)
            onPage(pageWith(listOf(finding("Brownout", Severity.ERROR, "three times", 1.0, 1.2, further), twin))) {
                texts(".finding .event-go") shouldBe listOf("1.000 – 1.200", "9.000")
                graph("Angle").hover(0.42)
                graph("Angle").label shouldBe "error · Brownout: three times"
                graph("Angle").hover(0.9)
                graph("Angle").label shouldBe "error · Brownout: three times (and 1 more)"
                graph("Angle").hover(0.05)
                listOf(1, 1, 1, 1, -1).map {
                    if (it > 0) press("n") else pressShift("n")
                    cursor()
                } shouldBe listOf(1.0, 4.0, 9.0, 9.0, 4.0)
                element(".finding[aria-current]").text shouldContain "three times"
            }
        }
        step("without findings there is no list, and their keys do nothing; without events there is no link to them") {
            onPage(TestPages.of(stepBag(graphs = 1))) {
                element("#findings").isDisplayed shouldBe false
                element("#problems").isDisplayed shouldBe false
                element(".events-link").isDisplayed shouldBe false
                press("n")
                pressShift("n")
                texts(".cursor-readout").single() shouldBe ""
            }
        }
        step("a finding outside the recording leads to its nearest end") {
            onPage(pageWith(listOf(-1e300, 1e300).map { finding("R", Severity.ERROR, "far", it, 1e301) })) {
                press("n")
                cursor() shouldBe 0.0
                elements(".finding .event-go")[1].click()
                settle()
                10.0 shouldBeIn visibleRange
            }
        }
    }
})
