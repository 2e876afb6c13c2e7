package badlog.page

import badlog.core.bag.BagTopic
import io.kotest.core.annotation.Tags
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

    browserTest("a search finds graphs, values and events") {
        onPage(page) {
            step("a slash focuses the search, where keys are letters; the search shows its number of matches, and Escape ends it") {
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
            script("document.activeElement.blur()")
            step("a search matches values and events, also in closed folders") {
                script("document.getElementById('collapse-all').click()")
                graphNames shouldBe emptyList()
                press("/")
                press("stalled")
                graphNames shouldBe emptyList()
                elements(".event").single { it.isDisplayed }.text shouldContain "elevator stalled"
                retype("blue")
                elements(".values .value-row").filter { it.isDisplayed }.map { it.text }
                    .filter { "Blue" in it }.size shouldBe 1
            }
        }
    }
})
