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

/** The screen before any scrolling: the findings, and a graph that shows one, on a phone. */
@Tags("InCheck")
internal class FirstScreenSpec : PageSpec({
    fun ruled(sample: String) = TestPages.ofSample(sample, PageAdditions(rules = RuleSet.BUILT_IN))

    fun OpenPage.incidents() = elements(".incident").filter { it.isDisplayed }

    fun OpenPage.checkFirstGraph() {
        await("the rules") { element(".findings-skipped").isDisplayed }
        number("return document.querySelector('.graph.card').getBoundingClientRect().top") shouldBeLessThan 700.0
    }

    browserTest("the first screen of a phone has the worst incident or loss, and the top of a graph") {
        step("the first screen of a phone has the worst incident and the top of a graph; a key shows other incidents") {
            onPage(ruled("qualification-42.bag"), Screen.PHONE) {
                await("incidents") { incidents().size == 1 }
                checkFirstGraph()
                press("nn")
                incidents().last().text shouldContain "the loop stood still"
                incidents().last().getDomAttribute("aria-current") shouldBe "true"
                // A list without rows is not in the tab order.
                element(".findings-list").getDomAttribute("tabindex") shouldBe null
                elements(".finding").count { it.isDisplayed } shouldBe 0
            }
        }
        step("the first screen of a phone has the top of a damaged log's graph") {
            onPage(ruled("practice.bag"), Screen.PHONE) {
                checkFirstGraph()
                number("return document.documentElement.scrollWidth") shouldBeLessThanOrEqual 390.0
            }
        }
    }
})
