package badlog.page

import badlog.core.recording.Severity
import badlog.protocol.PageAdditions
import badlog.rules.BUILT_IN
import badlog.rules.RuleSet
import io.kotest.assertions.withClue
import io.kotest.core.annotation.Tags
import io.kotest.matchers.doubles.plusOrMinus
import io.kotest.matchers.doubles.shouldBeLessThan
import io.kotest.matchers.shouldBe
import io.kotest.matchers.string.shouldContain
import io.kotest.matchers.string.shouldStartWith
import org.openqa.selenium.By
import org.openqa.selenium.Keys
import kotlin.math.abs

/** From a finding to its reason: all evidence is on one screen. */
@Tags("InCheck")
internal class EvidenceSpec : PageSpec({
    fun OpenPage.cursor() = texts(".cursor-readout").single().substringBefore(' ').toDouble()

    /** Returns the names of the graphs that are fully on the screen below the bar, with their lines. */
    fun OpenPage.inSight(): String = script(
        """
        const top = document.querySelector('.zoom-bar').getBoundingClientRect().bottom
        return [...document.querySelectorAll('#evidence .graph')].filter(graph => {
            const box = graph.querySelector('canvas')?.getBoundingClientRect()
            return box && box.height > 30 && box.top >= top && box.bottom <= innerHeight
        }).map(graph => [graph.dataset.name, ...[...graph.querySelectorAll('[data-series]')].map(line => line.dataset.series)].join()).join('\n')
        """.trimIndent(),
    ) as String

    /** Returns the number of graphs that are not fully on the screen below the bar. */
    fun OpenPage.outOfSight() = elements("#evidence .graph").size - inSight().lines().count { it.isNotEmpty() }

    val match by lazy { TestPages.ofSample("qualification-42.bag", PageAdditions(rules = RuleSet.BUILT_IN)) }

    browserTest("evidence is one click, key or link away, and on one screen") {
        val focused = "const e = document.activeElement; return (e.closest('.incident, .finding')?.className ?? '') + '|' + " +
            "(e.closest('p, .finding')?.textContent ?? e.id)"
        onPage(match) {
            step("N opens a whole incident, with more graphs one click away; it can be closed, and a link to its time opens it again") {
                press("n")
                val sentences = texts("#evidence .evidence-text").filter { it.isNotEmpty() }
                sentences.first() shouldContain "Likely cause"
                texts(".incident p").first() shouldContain sentences.first()
                texts("#evidence .severity") shouldBe texts(".incident .severity").take(1)
                texts("#spoken").single() shouldContain " s: error: ${sentences.first()}"
                press(Keys.ARROW_RIGHT)
                texts("#spoken").single() shouldContain " V"
                val before = elements("#evidence .graph").size
                val offers = elements(".evidence-offers button")
                withClue(offers.map { it.text }) { offers.isEmpty() shouldBe false }
                offers.first().click()
                settle()
                elements("#evidence .graph").size shouldBe before + 1
                click("#close-evidence")
                element("#evidence").isDisplayed shouldBe false
                elements("#evidence .graph").size shouldBe 0
                val time = 93.709649
                script("location.hash = '#t=' + arguments[0]", time)
                await("the evidence at that moment") { element("#evidence").isDisplayed && abs(cursor() - time) < 0.01 }
            }
            click("#close-evidence")
            press("0")
            step("the reason for the brownout in Qualification 42 is one click away on each screen") {
                for (screen in listOf(Screen(1366, 768), Screen.PHONE)) {
                    show(screen)
                    elements(".incident p").first { "browned out" in it.text }.findElement(By.cssSelector("button")).click()
                    await("four graphs in sight") { elements("#evidence .graph").size == 4 && outOfSight() == 0 }
                    keepScreenshot("evidence-${screen.width}")
                    cursor() shouldBe (93.7 plusOrMinus 0.1)
                    (93.7 in visibleRange) shouldBe true
                    visibleRange.endInclusive - visibleRange.start shouldBeLessThan 20.0
                    for (name in listOf("Battery Voltage", "Total Current", "Left Output", "Right Output")) inSight() shouldContain name
                    element("#evidence .evidence-text").text shouldStartWith "The roboRIO browned out at 93.7"
                    element("#evidence .incident-next").text shouldStartWith "Next: "
                    element(".incident[aria-current]").text shouldContain "browned out"
                }
            }
            show(Screen.WIDE)
            press("0")
            step("a link to a finding focuses its row once the rules have found it, unless the reader has moved the focus") {
                elements(".incident p").first { "browned out" in it.text }.findElement(By.cssSelector("button")).click()
                settle()
                script("Object.defineProperty(navigator, 'clipboard', {value: {writeText: async text => { window.copied = text }}})")
                click("#copy-link")
                val link = "#" + (script("return window.copied") as String).substringAfter('#')
                link shouldContain "&finding="
                script("location.hash = arguments[0]; document.activeElement.blur()", link)
                reload()
                script(focused) as String shouldContain "browned out"
                script(focused) as String shouldStartWith "incident|"
                // The evidence is on the screen, so focusing it scrolls nothing.
                await("the evidence in sight") { outOfSight() == 0 }
                press(Keys.ENTER)
                cursor() shouldBe (93.7 plusOrMinus 0.1)
                // A reader who began a search while the rules ran can continue it.
                val begun = "document.addEventListener('DOMContentLoaded', () => " +
                    "new MutationObserver(() => document.querySelector('#search')?.focus()).observe(document.documentElement, {attributes: true, attributeFilter: ['data-state']}))"
                runFirst(begun)
                reload()
                script(focused) shouldBe "|search"
            }
            step("on a screen of any width, time and match clock are readable beside modes and events") {
                for (width in listOf(1366, 1101, 961, 900)) {
                    show(Screen(width, 800))
                    graph("System/Battery Voltage").scrollTo().hover(0.6)
                    withClue("$width px") {
                        for (readout in listOf(".cursor-readout", ".clock-readout")) {
                            number(
                                """
                                const text = document.querySelector(arguments[0]).getBoundingClientRect();
                                const room = document.querySelector('.readout').getBoundingClientRect();
                                return text.width > 20 ? text.right - room.right : 999;
                                """.trimIndent(),
                                readout,
                            ) shouldBeLessThan 1.5
                        }
                    }
                }
            }
        }
    }

    browserTest("a link and N select the right one of two findings that begin together, and its address names it") {
        val both = listOf(
            finding("First", Severity.ERROR, "first of two", 3.0),
            finding("Second", Severity.WARNING, "second of two", 3.0),
        )
        onPage(TestPages.of(stepBag(graphs = 1), additions = PageAdditions(findings = both))) {
            fun sentence() = texts("#evidence .evidence-text").first()
            fun address() = element(".cursor-readout").getDomAttribute("href")
            script("location.hash = '#t=3'")
            settle()
            sentence() shouldBe "first of two"
            script("location.hash = '#t=3&finding=Second'")
            await("the sentence of the other") { sentence() == "second of two" }
            // The bar above is updated a frame later.
            settle()
            address() shouldBe "#t=3&finding=Second"
            texts(".event-readout").single() shouldContain "second of two"
            click("#close-evidence")
            pressShift("n")
            settle()
            sentence() shouldBe "first of two"
            address() shouldBe "#t=3&finding=First"
            script("location.hash = '#t=3&finding=Gone;Topic'")
            settle()
            sentence() shouldBe "first of two"
        }
    }
})
