package badlog.page

import badlog.core.bag.BagTopic
import badlog.core.recording.Severity
import badlog.core.recording.Value
import badlog.protocol.HookPart
import badlog.protocol.PageAdditions
import io.kotest.core.annotation.Tags
import io.kotest.matchers.collections.shouldBeEmpty
import io.kotest.matchers.collections.shouldContain
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.shouldNotBe
import org.openqa.selenium.Keys

@Tags("InCheck")
internal class KeyboardSpec : PageSpec({
    val topics = listOf(
        TIME,
        BagTopic("Arm/Angle", "deg", listOf("join:Arm/Tracking")),
        BagTopic("Arm/Setpoint", "deg", listOf("hide", "join:Arm/Tracking")),
        BagTopic("Odd?"),
        BagTopic("Log", attributes = listOf("log")),
    )
    val bag = bagOf(topics, 101, mapOf("Match" to "8")) { row, column ->
        if (column == 4) "brownout".takeIf { row == 60 } else row
    }
    val page by lazy { TestPages.of(bag) }
    val pageWithAll by lazy {
        val findings = List(8) { finding("Rule", Severity.WARNING, "found", it.toDouble(), Double.NaN) }
        val hook = HookPart("analyze.py", values = listOf(Value("Energy", "1.7")))
        TestPages.of(bag, additions = PageAdditions(listOf("Twice = Angle * 2", "Bad ="), findings = findings, hooks = listOf(hook)))
    }

    browserTest("Tab reaches everything, the first one skips to the graphs, and each Escape ends one thing") {
        onPage(pageWithAll) {
            step("Tab reaches everything that can be pressed, and its place is visible") {
                val unseen = ArrayList<String>()
                var steps = 0
                do {
                    press(Keys.TAB)
                    val seen = script(
                        """
                        const e = document.activeElement;
                        if (!e || e === document.body) return null;
                        e.dataset.reached = '1';
                        const style = getComputedStyle(e), box = e.getBoundingClientRect();
                        const isMarked = style.outlineStyle !== 'none' && parseFloat(style.outlineWidth) >= 2;
                        const isOnScreen = box.bottom > 0 && box.top < innerHeight && box.width > 0;
                        return isMarked && isOnScreen ? '' : e.outerHTML.slice(0, 120);
                        """.trimIndent(),
                    ) as String?
                    if (!seen.isNullOrEmpty()) unseen += seen
                    steps++
                } while (seen != null && steps < 100)
                unseen.shouldBeEmpty()
                script(
                    "return [...document.querySelectorAll('button, input, select, summary, .plot, .events-scroll')]" +
                        ".filter(e => e.checkVisibility() && !e.disabled && !e.dataset.reached)" +
                        ".map(e => e.outerHTML.slice(0, 120))",
                ) shouldBe emptyList<String>()
            }
            startOver()
            step("the first Tab offers the link to the graphs, and every button and field has an accessible name") {
                script(
                    "return [...document.querySelectorAll('button, input, select')].filter(e => e.checkVisibility())" +
                        ".filter(e => !(e.getAttribute('aria-label') || e.textContent.trim())).map(e => e.outerHTML)",
                ) shouldBe emptyList<String>()
                element(".skip").rect.let { it.width > 0 && it.height > 0 } shouldBe true
                press(Keys.TAB, Keys.ENTER)
                script("return document.activeElement.className") shouldBe "plot"
                graph(graphNames.first()).isOnScreen shouldBe true
            }
            step("each Escape ends one thing: the search, the evidence, the second cursor, the pin, the cursor") {
                press("n")
                act { sendKeys("b").sendKeys(Keys.ARROW_RIGHT) }
                click("#search")
                press("arm")
                script("document.activeElement.blur()")
                val search = { element("#search").getDomProperty("value") }
                val isOpen = { element("#evidence").isDisplayed }
                fun cursors() = elements(".second-readout").count { it.isDisplayed } to element(".cursor-readout").isDisplayed
                press(Keys.ESCAPE)
                listOf(search(), isOpen(), cursors()) shouldBe listOf("", true, 1 to true)
                press(Keys.ESCAPE)
                listOf(isOpen(), cursors()) shouldBe listOf(false, 1 to true)
                press(Keys.ESCAPE)
                cursors() shouldBe (0 to true)
                press(Keys.ESCAPE)
                cursors() shouldBe (0 to false)
            }
        }
    }

    browserTest("keys move the cursor, zoom, open the help, and press what has the focus") {
        onPage(page) {
            step("arrows move the cursor, plus and 0 zoom") {
                press(Keys.ARROW_RIGHT)
                val start = graph("Arm/Angle").value("Angle").toInt()
                pressShift(Keys.ARROW_RIGHT)
                graph("Arm/Angle").value("Angle").toInt() shouldBe start + 10
                press("+")
                visibleRange.endInclusive - visibleRange.start shouldBeLessThan 100.0
                press("0")
                visibleRange shouldBe 0.0..100.0
            }
            press(Keys.ESCAPE)
            step("a question mark opens the help, which keeps the focus, and Escape closes it") {
                press("?")
                element("#help").isDisplayed shouldBe true
                script("return document.getElementById('help').contains(document.activeElement)") shouldBe true
                press(Keys.ARROW_RIGHT)
                graph("Arm/Angle").value("Angle") shouldBe ""
                press(Keys.ESCAPE)
                element("#help").isDisplayed shouldBe false
                click("#help-button")
                element("#help").isDisplayed shouldBe true
                press("?")
                element("#help").isDisplayed shouldBe false
            }
            step("a folder, the problems and an event react to Enter and Space") {
                fun focus(selector: String) = script("document.querySelector(arguments[0]).focus()", selector)
                focus(".folder[data-name='Arm'] .folder-toggle")
                press(Keys.ENTER)
                graphNames shouldBe listOf("Odd?")
                press(Keys.SPACE)
                graphNames shouldContain "Arm/Angle"
                focus("#problems summary")
                val before = elements(".problem-list").size
                press(Keys.SPACE)
                elements(".problem-list").size shouldNotBe before
                focus(".event-go")
                press(Keys.ENTER)
                graph("Arm/Angle").scrollTo().value("Angle") shouldBe "60"
            }
        }
    }
})
