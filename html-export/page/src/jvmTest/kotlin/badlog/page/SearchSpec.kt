package badlog.page

import badlog.core.bag.BagTopic
import badlog.core.recording.Severity
import badlog.protocol.PageAdditions
import io.kotest.assertions.withClue
import io.kotest.core.annotation.Tags
import io.kotest.matchers.doubles.shouldBeGreaterThan
import io.kotest.matchers.ints.shouldBeGreaterThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import org.openqa.selenium.Keys

@Tags("InCheck")
internal class SearchSpec : PageSpec({
    val page by lazy {
        val topics = listOf(
            TIME,
            BagTopic("Drivetrain/Left Position", "m"),
            BagTopic("Drivetrain/Right Position", "m"),
            BagTopic("Elevator/Position", "m"),
            BagTopic("Elevator/Current", "A"),
            BagTopic("System/Event Log", attributes = listOf("log")),
        )
        val values = mapOf("Alliance" to "Blue", "Elevator/P" to "3.5")
        TestPages.of(
            bagOf(topics, 100, values) { row, column ->
                if (column == 5) "elevator stalled".takeIf { row == 50 } else row / 100.0
            },
        )
    }

    /** Replaces the text of the focused field by [text]. */
    fun OpenPage.retype(text: String) = act { keyDown(Keys.CONTROL).sendKeys("a").keyUp(Keys.CONTROL).sendKeys(text) }

    val all = listOf("Drivetrain/Left Position", "Drivetrain/Right Position", "Elevator/Position", "Elevator/Current")

    browserTest("a slash focuses the search, where keys are letters; the search shows its number of matches, and Escape ends it") {
        onPage(page) {
            graphNames shouldBe all
            press("/")
            press("0+-?/")
            element("#search").getDomProperty("value") shouldBe "0+-?/"
            elements("dialog[open]").size shouldBe 0
            retype("POS elev")
            graphNames shouldBe listOf("Elevator/Position")
            texts(".search-count").single() shouldContain "1 graph"
            texts(".folder[data-name='Elevator'] .folder-toggle .count") shouldBe listOf("1")
            elements(".folder-link").single { it.isDisplayed }.text shouldContain "1"
            retype("gyro")
            graphNames shouldBe emptyList()
            element(".nothing-found").isDisplayed shouldBe true
            texts(".search-count").single() shouldContain "nothing"
            press(Keys.ESCAPE)
            graphNames shouldBe all
            element("#search").getDomProperty("value") shouldBe ""
        }
    }

    browserTest("a search matches values and events, also in closed folders") {
        onPage(page) {
            script("document.getElementById('collapse-all').click()")
            graphNames shouldBe emptyList()
            press("/")
            press("stalled")
            graphNames shouldBe emptyList()
            elements("tr.event").single { it.isDisplayed }.text shouldContain "elevator stalled"
            retype("blue")
            elements(".values .value-row").filter { it.isDisplayed }.map { it.text }
                .filter { "Blue" in it }.size shouldBe 1
        }
    }

    browserTest("matching graphs are drawn and follow the zoom") {
        onPage(page) {
            press("/")
            press("current")
            graph("Elevator/Current").scrollTo().drag(0.2, 0.6)
            val zoomed = visibleRange
            zoomed.start shouldBeGreaterThan 0.1
            click("#search")
            press(Keys.ESCAPE)
            graph("Drivetrain/Left Position").scrollTo().pixelsOfLine(0) shouldBeGreaterThan 0
            visibleRange shouldBe zoomed
        }
    }

    browserTest("a search can ask for kinds of events and of topics") {
        onPage(page) {
            press("/")
            press("is:event")
            graphNames shouldBe emptyList()
            withClue(text.take(2000)) { elements("tr.event").count { it.isDisplayed } shouldBe 1 }
            retype("is:number -is:constant")
            graphNames shouldBe all
            retype("-is:number")
            graphNames shouldBe emptyList()
        }
    }

    browserTest("findings hidden by a search are counted, and a button shows them again") {
        val findings = listOf(finding("Low", Severity.ERROR, "too low", 3.0), finding("High", Severity.NOTE, "too high", 5.0))
        onPage(TestPages.of(stepBag(graphs = 2), additions = PageAdditions(findings = findings))) {
            press("/")
            press("step")
            elements(".finding").size shouldBe 0
            element(".findings-hidden").text shouldContain "2 findings hidden by the search"
            click(".findings-hidden button")
            elements(".finding").size shouldBe 2
            elements(".findings-hidden").isEmpty() shouldBe true
            graphNames shouldBe listOf("Step 1", "Step 2")
            retype("has:finding")
            elements(".finding").size shouldBe 2
        }
    }
})
