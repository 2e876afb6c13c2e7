package badlog.page

import badlog.protocol.PageAdditions
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import io.kotest.core.annotation.Tags
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.doubles.shouldBeLessThanOrEqual
import io.kotest.matchers.ints.shouldBeLessThanOrEqual
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import org.openqa.selenium.By

/** The screen before any scrolling: the findings, and a graph that shows one. */
@Tags("InCheck")
internal class FirstScreenSpec : PageSpec({
    val laptop = Screen(1366, 768)

    fun ruled(sample: String) = TestPages.ofSample(sample, PageAdditions(rules = RuleSet.BUILT_IN))

    fun OpenPage.incidents() = elements(".incident").filter { it.isDisplayed }

    fun OpenPage.checkFirstGraph() {
        await("the rules") { element(".findings-skipped").isDisplayed }
        number("return document.querySelector('.graph.card').getBoundingClientRect().top") shouldBeLessThan 700.0
    }

    browserTest("the first screen of a laptop and of a phone has the worst incident or loss, and the top of a graph") {
        step("the first screen of a laptop shows all incidents and a whole graph") {
            onPage(ruled("qualification-42.bag"), laptop) {
                await("incidents") { incidents().size == 2 }
                number("return document.querySelector('.graph.card').getBoundingClientRect().bottom") shouldBeLessThan 768.0
            }
        }
        step("the first screen of a phone includes the top of a practice's path") {
            onPage(ruled("wrong-turn.bag"), Screen.PHONE) { checkFirstGraph() }
        }
        step("the first screen of a phone has the worst incident and the top of a graph; other incidents appear on request or by a key") {
            onPage(ruled("qualification-42.bag"), Screen.PHONE) {
                await("incidents") { incidents().size == 1 }
                checkFirstGraph()
                element(".findings-more button").text shouldBe "Show 4 more"
                click(".findings-more button")
                incidents().size shouldBe 2
                elements(".finding").count { it.isDisplayed } shouldBe 3
                element(".findings-more button").text shouldBe "Show fewer"
                click(".findings-more button")
                incidents().size shouldBe 1
                elements(".finding").count { it.isDisplayed } shouldBe 0
                press("nn")
                incidents().last().text shouldContain "the loop stood still"
                incidents().last().getDomAttribute("aria-current") shouldBe "true"
                // A list without rows is not in the tab order.
                element(".findings-list").getDomAttribute("tabindex") shouldBe null
                elements(".finding").count { it.isDisplayed } shouldBe 0
            }
        }
        step("the first screen of a phone has the top of a damaged log's graph, and lists its losses on request") {
            onPage(ruled("practice.bag"), Screen.PHONE) {
                checkFirstGraph()
                number("return document.documentElement.scrollWidth") shouldBeLessThanOrEqual 390.0
                val toggle = element("#problems summary")
                toggle.text shouldContain "Data is missing in 4 places"
                elements(".problem").isEmpty() shouldBe true
                toggle.click()
                element(".problem").findElement(By.cssSelector(".problem-text")).text shouldContain "cut off"
            }
        }
    }
})
